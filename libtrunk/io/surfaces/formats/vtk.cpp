#include <fmt/format.h>

#include "surfaces/formats/numbers.hpp"
#include "surfaces/formats/raw_surface.hpp"
#include "surfaces/formats/words.hpp"
#include "text/message_text.hpp"

namespace trunk {
namespace {

constexpr std::size_t most_corners = 4 * most_surface_triangles;

/// Corners of all cells, and the end of each cell in this list.
struct VtkCells {
  std::vector<double> corners, ends;
};

/// Reads the legacy format of VTK: POLYDATA and UNSTRUCTURED_GRID as text or binary (big-endian), versions 1
/// to 5.
class VtkReader {
 public:
  VtkReader(const std::string& bytes, const std::string& file)
      : bytes_(bytes), words_(bytes, file), builder_(file, "VTK") {}

  RawSurface read() {
    read_vtk_header();
    for (std::string_view word = words_.next(); !word.empty(); word = words_.next()) {
      if (same_word(word, "POINTS"))
        read_points();
      else if (same_word(word, "POLYGONS") || same_word(word, "TRIANGLE_STRIPS"))
        add_cells(same_word(word, "TRIANGLE_STRIPS"));
      else if (same_word(word, "VERTICES") || same_word(word, "LINES"))
        read_cells();
      else if (same_word(word, "CELLS"))
        grid_ = read_cells();
      else if (same_word(word, "CELL_TYPES"))
        read_types();
      else if (same_word(word, "FIELD"))
        skip_to_points();
      else if (same_word(word, "METADATA"))
        skip_to_blank_line();
      else if (same_word(word, "POINT_DATA") || same_word(word, "CELL_DATA"))
        break;  // the surface stands before these
      else
        words_.fail(fmt::format("{} found", excerpt(word)), "POINTS, POLYGONS, TRIANGLE_STRIPS or CELLS",
                    "export it again");
    }
    return builder_.finish();
  }

 private:
  void read_vtk_header() {
    words_.skip_line();
    builder_.remark(words_.rest_of_line());  // the title
    const std::string_view coding = words_.rest_of_line();
    binary_ = same_word(coding, "BINARY");
    if (!binary_ && !same_word(coding, "ASCII"))
      words_.fail(fmt::format("{} found", excerpt(coding)), "ASCII or BINARY in the third line",
                  "export the surface again");
    if (!same_word(words_.next(), "DATASET"))
      words_.fail("no DATASET found after the header", "DATASET POLYDATA", "export the surface again");
    const std::string_view kind = words_.rest_of_line();
    if (same_word(kind, "STRUCTURED_POINTS"))
      words_.fail("an image or a label map found, which is no surface yet", "POLYDATA or UNSTRUCTURED_GRID",
                  "make a surface of it (3D Slicer: Segmentations, Export; ParaView: Contour) and save that");
    if (!same_word(kind, "POLYDATA") && !same_word(kind, "UNSTRUCTURED_GRID"))
      words_.fail(fmt::format("DATASET {} found", excerpt(kind)), "POLYDATA or UNSTRUCTURED_GRID",
                  "extract the surface and save that");
  }

  std::vector<double> numbers(std::size_t count, NumberType type) {
    std::vector<double> values;
    if (!binary_) {
      for (std::size_t i = 0; i < count; ++i) values.push_back(words_.number("a number"));
      return values;
    }
    const std::string_view raw = words_.bytes(count * type.bytes);
    for (std::size_t i = 0; i < count; ++i)
      values.push_back(number_at(raw.data() + i * type.bytes, type, true));
    return values;
  }

  /// Reads the last word of a line, which is the type of the numbers that follow.
  NumberType type_at_end_of_line() {
    const std::string_view name = words_.rest_of_line();
    const auto type = number_type(name);
    if (!type)
      words_.fail(fmt::format("numbers of type {} found", excerpt(name)), "float, double or int",
                  "export the surface again");
    return *type;
  }

  void read_points() {
    const std::size_t count = words_.count("how many points there are", most_surface_points);
    const NumberType type = type_at_end_of_line();
    for (std::size_t i = 0; i < (binary_ ? 0 : count); ++i) {
      const double x = words_.number("a coordinate"), y = words_.number("a coordinate"),
                   z = words_.number("a coordinate");
      builder_.point({x, y, z}, words_.line());
    }
    if (!binary_) return;
    const std::vector<double> all = numbers(3 * count, type);
    for (std::size_t i = 0; i < all.size(); i += 3) builder_.point({all[i], all[i + 1], all[i + 2]});
  }

  /// Reads "POLYGONS cells numbers", followed by the number of corners and the corners of each cell. From
  /// version 5 on, it is "POLYGONS offsets corners", followed by OFFSETS and CONNECTIVITY.
  VtkCells read_cells() {
    const std::size_t first = words_.count("how many polygons there are", most_corners);
    const std::size_t second = words_.count("how many numbers they take", most_corners);
    words_.skip_line();
    VtkCells cells;
    auto& [corners, ends] = cells;
    Words ahead = words_;
    if (same_word(ahead.word_of_line(), "OFFSETS")) {
      ends = named_numbers("OFFSETS", first);
      corners = named_numbers("CONNECTIVITY", second);
      if (!ends.empty()) ends.erase(ends.begin());
    } else {
      const std::vector<double> listed = numbers(second, {NumberType::Kind::whole, 4});
      for (std::size_t i = 0; i < listed.size();) {
        const double count = listed[i++];
        if (!(count >= 0.0 && count <= static_cast<double>(listed.size() - i)))
          words_.fail(fmt::format("a polygon of {} corners found where {} numbers are left", count,
                                  listed.size() - i),
                      "", "export it again");
        const auto next = i + static_cast<std::size_t>(count);
        for (; i < next; ++i) corners.push_back(listed[i]);
        ends.push_back(static_cast<double>(corners.size()));
      }
    }
    return cells;
  }

  void add_cells(bool strips) {
    const VtkCells cells = read_cells();
    builder_.cells(cells.corners, cells.ends, strips);
  }

  /// Reads the types of the cells of an UNSTRUCTURED_GRID, and adds these cells.
  void read_types() {
    const std::size_t count = words_.count("how many cells there are", most_corners);
    words_.skip_line();
    builder_.cells(grid_.corners, grid_.ends, numbers(count, {NumberType::Kind::whole, 4}));
  }

  std::vector<double> named_numbers(std::string_view name, std::size_t count) {
    if (!same_word(words_.next(), name))
      words_.fail(fmt::format("no {} found after the cells", name), "", "export it again");
    const NumberType type = type_at_end_of_line();
    return numbers(count, type);
  }

  /// Skips the fields before the points, but takes the axes from the field SPACE that 3D Slicer writes.
  void skip_to_points() {
    const std::size_t points = bytes_.find("\nPOINTS", words_.position());
    if (points == std::string::npos)
      words_.fail("no POINTS found after FIELD", "POINTS", "export the surface again");
    const std::string_view fields = words_.bytes(points - words_.position());
    constexpr std::string_view space = "\nSPACE 1 1 string\n";
    const std::size_t at = fields.find(space);
    if (at == std::string_view::npos) return;
    // Before the text of a binary file stand its length and two bits that say how many bytes the length
    // takes.
    const std::string_view text = fields.substr(at + space.size());
    builder_.axes(binary_ && !text.empty() ? text.substr(1, static_cast<unsigned char>(text[0]) & 0x3F)
                                           : text);
  }

  void skip_to_blank_line() {
    words_.skip_line();
    for (std::size_t before = words_.position(); !words_.rest_of_line().empty(); before = words_.position())
      if (words_.position() == before) return;
  }

  const std::string& bytes_;
  Words words_;
  SurfaceBuilder builder_;
  bool binary_ = false;
  VtkCells grid_;  // of an UNSTRUCTURED_GRID, until their types are read
};

}  // namespace

RawSurface read_vtk(const std::string& bytes, const std::string& file) {
  return VtkReader(bytes, file).read();
}

}  // namespace trunk
