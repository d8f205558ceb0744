#include <fmt/format.h>

#include <filesystem>

#include "errors/input_error.hpp"
#include "files/read_file.hpp"
#include "surfaces/formats/raw_surface.hpp"
#include "surfaces/formats/vtp_arrays.hpp"
#include "text/message_text.hpp"

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

/// Reads the cells of a piece of an unstructured grid, as `read_vtp_cells`.
void read_vtu_cells(const pml::XmlDocument& xml, const VtpArrays& arrays, pugi::xml_node parent,
                    double first_point, SurfaceBuilder& builder) {
  if (!parent || !parent.child("DataArray")) return;
  std::vector<double> corners =
      arrays.numbers(array_named(xml, parent, "connectivity"), 4 * most_surface_triangles);
  for (double& corner : corners) corner += first_point;
  builder.cells(corners, arrays.numbers(array_named(xml, parent, "offsets"), most_surface_triangles),
                arrays.numbers(array_named(xml, parent, "types"), most_surface_triangles));
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
  read_vtu_cells(xml, arrays, xml.at_most_one(piece, "Cells"), first, builder);
}

/// Takes the axes from the field SPACE, as 3D Slicer writes it. => builder
void read_vtp_space(const VtpArrays& arrays, pugi::xml_node data, SurfaceBuilder& builder) {
  for (const pugi::xml_node fields : data.children("FieldData"))
    for (const pugi::xml_node array : fields.children())
      if (array.attribute("Name").as_string() == std::string_view("SPACE")) builder.axes(arrays.text(array));
}

/// Reads the pieces that a PVTP or PVTU lists, each a file in the same folder or below it.
RawSurface read_listed_pieces(const pml::XmlDocument& xml, pugi::xml_node list, const std::string& file) {
  namespace fs = std::filesystem;
  RawSurface all;
  for (const pugi::xml_node piece : list.children("Piece")) {
    const fs::path source = fs::path(std::string(xml.value(piece, "Source"))).lexically_normal();
    if (source.empty() || source.is_absolute() || *source.begin() == "..")
      xml.fail(piece, fmt::format("the piece {} found", excerpt(source.string())),
               "a file in the folder of this list or below it", "put it there");
    const std::string path = (fs::path(file).parent_path() / source).string();
    const std::string bytes = read_file(path, largest_surface_file);
    if (bytes.find("<Piece Source") != std::string::npos ||
        bytes.find("type=\"PPolyData\"") != std::string::npos)
      throw InputError({path}, "a list of pieces in a list of pieces", "a VTP or VTU file");
    RawSurface part = read_raw_surface(bytes, path);
    const auto before = static_cast<int>(all.points.size());
    if (all.points.size() + part.points.size() > most_surface_points ||
        all.triangles.size() + part.triangles.size() > most_surface_triangles)
      xml.fail(piece, "too many points or triangles found", fmt::format("at most {}", most_surface_points),
               "thin the surface");
    all.points.insert(all.points.end(), part.points.begin(), part.points.end());
    for (const Triangle& t : part.triangles)
      all.triangles.push_back({t[0] + before, t[1] + before, t[2] + before});
    if (!part.axes.empty()) all.axes = part.axes;
  }
  if (all.triangles.empty()) xml.fail(list, "a list without pieces", "<Piece Source=...>", "export it again");
  all.format = "VTP in pieces";
  all.part.assign(all.triangles.size(), 0);
  all.parts = {""};
  return all;
}

}  // namespace

RawSurface read_vtp(const std::string& bytes, const std::string& file) {
  const VtpText text = vtp_text(bytes);
  const pml::XmlDocument xml(text.xml, file, "VTP");
  const std::string type = xml.root().attribute("type").as_string();
  if (type == "PPolyData" || type == "PUnstructuredGrid")
    return read_listed_pieces(xml, xml.only(xml.root(), type.c_str()), file);
  if (type == "ImageData")
    xml.fail(xml.root(), "an image or a label map found, which is no surface yet", "PolyData",
             "make a surface of it (3D Slicer: Segmentations, Export; ParaView: Contour) and save that");
  if (type != "PolyData" && type != "UnstructuredGrid")
    xml.fail(xml.root(), "a VTK file found that is not of type PolyData or UnstructuredGrid", "",
             "extract the surface and save that");
  SurfaceBuilder builder(file, type == "PolyData" ? "VTP" : "VTU");
  builder.remark(std::string_view(text.xml).substr(0, 2000));
  const VtpArrays arrays(xml, text.appended, text.raw);
  const pugi::xml_node data = xml.only(xml.root(), type.c_str());
  read_vtp_space(arrays, data, builder);
  for (const pugi::xml_node piece : data.children("Piece")) read_vtp_piece(xml, arrays, piece, builder);
  return builder.finish();
}

}  // namespace trunk
