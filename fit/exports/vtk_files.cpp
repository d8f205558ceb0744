#include "exports/vtk_files.hpp"

#include <fmt/format.h>

#include <iterator>
#include <span>

#include "errors/input_error.hpp"

namespace trunk {
namespace {

using Out = std::back_insert_iterator<std::string>;

/// Ten digits resolve a tenth of a nanometre in a metre.
void add_numbers(const char* name, int components, std::span<const double> values, std::string& xml) {
  fmt::format_to(Out(xml),
                 "<DataArray type=\"Float64\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"ascii\">\n",
                 name, components);
  for (const double v : values) fmt::format_to(Out(xml), "{:.10g} ", v);
  xml += "\n</DataArray>\n";
}

template <class Whole>
void add_codes(const char* name, std::span<const Whole> values, std::string& xml) {
  fmt::format_to(Out(xml), "<DataArray type=\"{}\" Name=\"{}\" format=\"ascii\">\n",
                 sizeof(Whole) == 8 ? "Int64" : "Int32", name);
  for (const Whole v : values) fmt::format_to(Out(xml), "{} ", v);
  xml += "\n</DataArray>\n";
}

template <class Cells>
void add_cells(const char* kind, const Cells& cells, std::string& xml) {
  std::vector<std::int64_t> corners, ends;
  for (const auto& one : cells) {
    corners.insert(corners.end(), one.begin(), one.end());
    ends.push_back(static_cast<std::int64_t>(corners.size()));
  }
  fmt::format_to(Out(xml), "<{}>\n", kind);
  add_codes<std::int64_t>("connectivity", corners, xml);
  add_codes<std::int64_t>("offsets", ends, xml);
  fmt::format_to(Out(xml), "</{}>\n", kind);
}

/// Returns the part that is the same in all frames: the cells and their data.
std::string mesh(const Trajectory& t) {
  std::string xml;
  add_cells("Lines", t.fibres, xml);
  add_cells("Polys", t.triangles, xml);
  if (t.triangle_component.empty()) return xml;
  const auto fibre = static_cast<std::int32_t>(t.component_names.size());
  std::vector<std::int32_t> component(t.fibres.size(), fibre);
  component.insert(component.end(), t.triangle_component.begin(), t.triangle_component.end());
  xml += "<CellData>\n";
  add_codes<std::int32_t>("component", component, xml);
  return xml + "</CellData>\n";
}

std::string frame(const Trajectory& t, std::size_t number, const std::string& same_in_all) {
  const std::size_t width = 3 * t.particles, first = number * width;
  const auto points = std::span(t.position_m).subspan(first, width);
  std::vector<double> displacement(points.begin(), points.end());
  for (std::size_t i = 0; i < width; ++i) displacement[i] -= t.position_m[i];
  std::string xml = fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n<PolyData>\n<FieldData>\n<DataArray type=\"Float64\" Name=\"TimeValue\" "
      "NumberOfTuples=\"1\" format=\"ascii\">{}</DataArray>\n</FieldData>\n<Piece NumberOfPoints=\"{}\" "
      "NumberOfVerts=\"0\" NumberOfLines=\"{}\" NumberOfStrips=\"0\" NumberOfPolys=\"{}\">\n<PointData "
      "Vectors=\"displacement\">\n",
      t.time_s[number], t.particles, t.fibres.size(), t.triangles.size());
  add_numbers("displacement", 3, displacement, xml);
  if (!t.velocity_m_s.empty())
    add_numbers("velocity", 3, std::span(t.velocity_m_s).subspan(first, width), xml);
  if (!t.contact.empty())
    add_codes("contact", std::span(t.contact).subspan(number * t.particles, t.particles), xml);
  if (!t.region.empty()) add_codes<std::int32_t>("region", t.region, xml);
  xml += "</PointData>\n<Points>\n";
  add_numbers("Points", 3, points, xml);
  return xml + "</Points>\n" + same_in_all + "</Piece>\n</PolyData>\n</VTKFile>\n";
}

}  // namespace

std::vector<NamedText> vtk_files(const Trajectory& t, const std::string& file) {
  if (t.particles == 0 || t.time_s.empty())
    throw InputError({file}, "has no trajectory", "a run simulated without --every 0");
  const std::string same_in_all = mesh(t);
  std::vector<NamedText> files;
  std::string list = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n";
  for (std::size_t number = 0; number < t.time_s.size(); ++number) {
    const std::string name = fmt::format("frames/frame_{:05}.vtp", number);
    files.push_back({name, frame(t, number, same_in_all)});
    fmt::format_to(Out(list), "<DataSet timestep=\"{}\" file=\"{}\"/>\n", t.time_s[number], name);
  }
  files.push_back({"trunk.pvd", list + "</Collection>\n</VTKFile>\n"});
  return files;
}

std::string surface_vtp(std::span<const double> points,
                        const std::vector<std::array<std::int32_t, 3>>& triangles,
                        const std::vector<NamedColumn>& columns) {
  std::string xml = fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n<PolyData>\n<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" "
      "NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"{}\">\n<PointData>\n",
      points.size() / 3, triangles.size());
  for (const NamedColumn& column : columns) add_numbers(column.name.c_str(), 1, column.values, xml);
  xml += "</PointData>\n<Points>\n";
  add_numbers("Points", 3, points, xml);
  xml += "</Points>\n";
  add_cells("Polys", triangles, xml);
  return xml + "</Piece>\n</PolyData>\n</VTKFile>\n";
}

}  // namespace trunk
