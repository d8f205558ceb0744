#include <fmt/format.h>

#include "surfaces/formats/raw_surface.hpp"
#include "surfaces/formats/vtp_arrays.hpp"

namespace trunk {
namespace {

/// The two parts of a VTK XML file: its XML, and its appended data, which are not XML if they are raw.
struct VtpText {
  std::string xml;
  std::string_view appended;
  bool raw = false;
};

VtpText vtp_text(const std::string& bytes) {
  const std::size_t tag = bytes.find("<AppendedData");
  const std::size_t tag_end = bytes.find('>', std::min(tag, bytes.size()));
  const std::size_t underscore = bytes.find('_', std::min(tag_end, bytes.size()));
  if (underscore == std::string::npos) return {bytes, {}, false};
  const std::string_view attributes = std::string_view(bytes).substr(tag, tag_end - tag);
  return {bytes.substr(0, underscore) + "</AppendedData></VTKFile>",
          std::string_view(bytes).substr(underscore + 1),
          attributes.find("\"raw\"") != std::string_view::npos ||
              attributes.find("'raw'") != std::string_view::npos};
}

pugi::xml_node array_named(const pml::XmlDocument& xml, pugi::xml_node parent, std::string_view name) {
  for (const pugi::xml_node array : parent.children("DataArray"))
    if (name.empty() || name == array.attribute("Name").as_string()) return array;
  xml.fail(parent, fmt::format("<{}> without an array {}", parent.name(), name), "one",
           "export the surface again");
}

/// Reads the cells of a piece. Its corners are counted from its own points.
void read_vtp_cells(const pml::XmlDocument& xml, const VtpArrays& arrays, pugi::xml_node parent, bool strips,
                    double first_point, SurfaceBuilder& builder) {
  if (!parent || !parent.child("DataArray")) return;
  std::vector<double> corners =
      arrays.numbers(array_named(xml, parent, "connectivity"), 4 * most_surface_triangles);
  const std::vector<double> ends =
      arrays.numbers(array_named(xml, parent, "offsets"), most_surface_triangles);
  for (double& corner : corners) corner += first_point;
  builder.cells(corners, ends, strips);
}

void read_vtp_piece(const pml::XmlDocument& xml, const VtpArrays& arrays, pugi::xml_node piece,
                    SurfaceBuilder& builder) {
  const pugi::xml_node points = xml.at_most_one(piece, "Points");
  if (!points || !points.child("DataArray")) return;  // an empty piece
  const pugi::xml_node array = array_named(xml, points, "");
  if (array.attribute("NumberOfComponents").as_int(1) != 3)
    xml.fail(array, "points found that do not have 3 components", "", "export the surface again");
  const auto first = static_cast<double>(builder.points());
  const std::vector<double> all = arrays.numbers(array, 3 * most_surface_points);
  for (std::size_t i = 0; i + 2 < all.size(); i += 3)
    builder.point({all[i], all[i + 1], all[i + 2]}, xml.line(array));
  read_vtp_cells(xml, arrays, xml.at_most_one(piece, "Polys"), false, first, builder);
  read_vtp_cells(xml, arrays, xml.at_most_one(piece, "Strips"), true, first, builder);
}

}  // namespace

RawSurface read_vtp(const std::string& bytes, const std::string& file) {
  const VtpText text = vtp_text(bytes);
  const pml::XmlDocument xml(text.xml, file, "VTP");
  const std::string_view type = xml.root().attribute("type").as_string();
  if (xml.root().name() != std::string_view("VTKFile") || type != "PolyData")
    xml.fail(xml.root(), "a VTK file found that is not of type PolyData", "",
             "extract the surface and save that");
  SurfaceBuilder builder(file, "VTP");
  builder.remark(std::string_view(text.xml).substr(0, 2000));
  const VtpArrays arrays(xml, text.appended, text.raw);
  for (const pugi::xml_node piece : xml.only(xml.root(), "PolyData").children("Piece"))
    read_vtp_piece(xml, arrays, piece, builder);
  return builder.finish();
}

}  // namespace trunk
