#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "surfaces/formats/numbers.hpp"
#include "surfaces/formats/raw_surface.hpp"
#include "surfaces/formats/words.hpp"
#include "text/message_text.hpp"

namespace trunk {
namespace {

struct PlyProperty {
  std::string name;
  NumberType type;
  std::optional<NumberType> count;  // of a list: the type of its length
};

struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;

  const PlyProperty* find(std::initializer_list<std::string_view> names) const {
    for (const PlyProperty& property : properties)
      for (const std::string_view name_ : names)
        if (property.name == name_) return &property;
    return nullptr;
  }
};

enum class PlyCoding { text, little_endian, big_endian };

struct PlyHeader {
  PlyCoding coding = PlyCoding::text;
  std::vector<PlyElement> elements;
};

NumberType ply_type(Words& words) {
  const std::string_view name = words.word_of_line();
  const auto type = number_type(name);
  if (!type)
    words.fail(fmt::format("property of type {} found", excerpt(name)), "a type of PLY, such as float or int",
               "correct it");
  return *type;
}

void read_ply_property(Words& words, std::vector<PlyElement>& elements) {
  constexpr std::size_t most_properties = 200;
  if (elements.empty())
    words.fail("a property found before the first element", "an element", "correct the header");
  if (elements.back().properties.size() >= most_properties)
    words.fail("an element with too many properties found", fmt::format("at most {}", most_properties),
               "remove some");
  PlyProperty property;
  Words list = words;
  if (list.word_of_line() == "list") {
    words = list;
    property.count = ply_type(words);
    if (property.count->kind == NumberType::Kind::real)
      words.fail("a list found whose length is a real number", "a whole number", "correct the header");
  }
  property.type = ply_type(words);
  property.name = words.word_of_line();
  elements.back().properties.push_back(property);
}

PlyHeader read_ply_header(Words& words, SurfaceBuilder& builder) {
  constexpr std::size_t most_elements = 100, most_entries = 100'000'000;
  PlyHeader header;
  for (words.skip_line();; words.skip_line()) {
    if (words.at_end()) words.fail("the header has no end", "end_header", "export the surface again");
    const std::string_view word = words.next();
    if (word == "end_header") return words.skip_line(), header;
    if (word == "format") {
      const std::string_view name = words.word_of_line();
      if (name == "binary_little_endian")
        header.coding = PlyCoding::little_endian;
      else if (name == "binary_big_endian")
        header.coding = PlyCoding::big_endian;
      else if (name != "ascii")
        words.fail(fmt::format("format {} found", excerpt(name)),
                   "ascii, binary_little_endian or binary_big_endian");
    } else if (word == "element") {
      if (header.elements.size() >= most_elements)
        words.fail(fmt::format("more than {} elements found", most_elements), "", "remove some");
      PlyElement element{std::string(words.word_of_line()), 0, {}};
      element.count = words.count("how many there are", most_entries);
      header.elements.push_back(element);
    } else if (word == "property") {
      read_ply_property(words, header.elements);
    } else if (word == "comment" || word == "obj_info") {
      Words comment = words;
      builder.remark(comment.rest_of_line());
    } else {
      words.fail(fmt::format("{} found in the header", excerpt(word)), "element, property or end_header",
                 "remove it");
    }
  }
}

/// Reads the numbers of the body, one after another, in any coding.
class PlyNumbers {
 public:
  PlyNumbers(const std::string& bytes, Words words, PlyCoding coding)
      : bytes_(bytes), words_(std::move(words)), at_(words_.position()), coding_(coding) {}

  double next(NumberType type) {
    if (coding_ == PlyCoding::text) return words_.number("a number");
    if (bytes_.size() - at_ < type.bytes)
      words_.fail("the file ends within the numbers its header names", "",
                  "check that the export was finished");
    const double value = number_at(bytes_.data() + at_, type, coding_ == PlyCoding::big_endian);
    at_ += type.bytes;
    return value;
  }

  std::size_t list_length(NumberType type) {
    const double length = next(type);
    if (!(length >= 0.0 && length <= static_cast<double>(most_surface_points)))
      words_.fail(fmt::format("a list of {} numbers found", length), "a length of 0 or more");
    return static_cast<std::size_t>(length);
  }

  std::size_t line() const { return coding_ == PlyCoding::text ? words_.line() : 0; }

 private:
  const std::string& bytes_;
  Words words_;
  std::size_t at_;
  PlyCoding coding_;
};

void read_ply_entry(PlyNumbers& numbers, const PlyElement& element, const PlyProperty* wanted,
                    std::array<double, 3>& position, std::vector<double>& list) {
  for (const PlyProperty& property : element.properties) {
    if (property.count) {
      const std::size_t length = numbers.list_length(*property.count);
      list.resize(&property == wanted ? length : list.size());
      for (std::size_t i = 0; i < length; ++i) {
        const double value = numbers.next(property.type);
        if (&property == wanted) list[i] = value;
      }
    } else {
      const double value = numbers.next(property.type);
      if (property.name.size() == 1 && property.name[0] >= 'x' && property.name[0] <= 'z')
        position[static_cast<std::size_t>(property.name[0] - 'x')] = value;
    }
  }
}

/// Adds strips that one list holds, with a negative number between them.
void add_ply_strips(std::span<const double> list, std::size_t line, SurfaceBuilder& builder) {
  for (std::size_t begin = 0; begin < list.size();) {
    std::size_t end = begin;
    while (end < list.size() && list[end] >= 0.0) ++end;
    builder.strip(list.subspan(begin, end - begin), line);
    begin = end + 1;
  }
}

}  // namespace

RawSurface read_ply(const std::string& bytes, const std::string& file) {
  SurfaceBuilder builder(file, "PLY");
  Words words(bytes, file);
  const PlyHeader header = read_ply_header(words, builder);
  PlyNumbers numbers(bytes, words, header.coding);
  std::size_t vertices = 0;
  for (const PlyElement& element : header.elements) {
    const bool is_vertex = element.name == "vertex", is_face = element.name == "face",
               is_strips = element.name == "tristrips";
    const PlyProperty* const corners = element.find({"vertex_indices", "vertex_index"});
    if (is_vertex && !(element.find({"x"}) && element.find({"y"}) && element.find({"z"})))
      builder.fail(0, "the vertices have no x, y and z", "all three", "export the surface again");
    if ((is_face || is_strips) && !(corners && corners->count))
      builder.fail(0, "the faces have no list vertex_indices", "one", "export the surface again");
    if (is_vertex) vertices = element.count;
    if (element.properties.empty()) continue;
    std::array<double, 3> position{};
    std::vector<double> list;
    for (std::size_t i = 0; i < element.count; ++i) {
      read_ply_entry(numbers, element, is_face || is_strips ? corners : nullptr, position, list);
      if (is_vertex) builder.point({position[0], position[1], position[2]}, numbers.line());
      if (is_face) builder.polygon(list, numbers.line(), vertices);
      if (is_strips) add_ply_strips(list, numbers.line(), builder);
    }
  }
  if (builder.points() < vertices)
    builder.fail(0, fmt::format("{} vertices found", builder.points()),
                 fmt::format("{}, as the header says", vertices), "export the surface again");
  return builder.finish();
}

}  // namespace trunk
