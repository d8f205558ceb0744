#include <fmt/format.h>

#include <array>

#include "surfaces/formats/numbers.hpp"
#include "surfaces/formats/raw_surface.hpp"
#include "surfaces/formats/words.hpp"
#include "text/message_text.hpp"

namespace trunk {
namespace {

constexpr std::size_t stl_header = 84, stl_facet = 50;  // bytes
constexpr NumberType stl_float{NumberType::Kind::real, 4}, stl_count{NumberType::Kind::natural, 4};

std::size_t bytes_announced(std::string_view bytes) {
  return stl_header + stl_facet * static_cast<std::size_t>(number_at(bytes.data() + 80, stl_count, false));
}

/// Reads binary STL. Every facet has its own points here; the repair merges equal ones.
RawSurface read_binary_stl(const std::string& bytes, const std::string& file) {
  SurfaceBuilder builder(file, "STL, binary");
  builder.remark(std::string_view(bytes).substr(0, 80));
  const std::size_t announced = bytes_announced(bytes);
  if (announced > bytes.size())
    builder.fail(0, fmt::format("a binary STL of {} bytes found", bytes.size()),
                 fmt::format("{} for the {} triangles its header names", announced,
                             (announced - stl_header) / stl_facet),
                 "check that the export was finished");
  for (std::size_t at = stl_header; at < announced; at += stl_facet) {
    std::array<double, 3> corners;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const auto number = [&](std::size_t axis) {
        return number_at(bytes.data() + at + 12 * (corner + 1) + 4 * axis, stl_float, false);
      };
      corners[corner] = static_cast<double>(builder.points());
      builder.point({number(0), number(1), number(2)});
    }
    builder.polygon(corners);
  }
  return builder.finish();
}

RawSurface read_text_stl(const std::string& bytes, const std::string& file) {
  SurfaceBuilder builder(file, "STL, text");
  Words words(bytes, file);
  std::vector<double> loop;
  for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
    if (same_word(word, "solid")) {
      const std::string_view name = words.rest_of_line();
      builder.remark(name);
      builder.begin_part(name);
    } else if (same_word(word, "vertex")) {
      const double x = words.number("a coordinate"), y = words.number("a coordinate"),
                   z = words.number("a coordinate");
      loop.push_back(static_cast<double>(builder.points()));
      builder.point({x, y, z}, words.line());
    } else if (same_word(word, "endloop")) {
      builder.polygon(loop, words.line());
      loop.clear();
    } else if (same_word(word, "facet") || same_word(word, "endsolid") || same_word(word, "color") ||
               word.front() == '#' || word.front() == ';') {
      words.skip_line();  // the normal is often nan, and the corners give it; colours and comments do not
                          // count
    } else if (!same_word(word, "outer") && !same_word(word, "loop") && !same_word(word, "endfacet")) {
      words.fail(fmt::format("{} found", excerpt(word)), "facet, vertex, endloop or endsolid of an STL",
                 "export it again");
    }
  }
  if (!loop.empty()) words.fail("the file ends within a facet", "", "check that the export was finished");
  return builder.finish();
}

}  // namespace

bool is_binary_stl(std::string_view bytes) {
  if (bytes.size() < stl_header) return false;
  if (bytes.size() == bytes_announced(bytes)) return true;
  const std::size_t announced = bytes_announced(bytes);
  return announced <= stl_header + stl_facet * most_surface_triangles && 2 * announced >= bytes.size() &&
         bytes.substr(0, 2000).find('\0') != std::string_view::npos;
}

RawSurface read_stl(const std::string& bytes, const std::string& file) {
  return is_binary_stl(bytes) ? read_binary_stl(bytes, file) : read_text_stl(bytes, file);
}

}  // namespace trunk
