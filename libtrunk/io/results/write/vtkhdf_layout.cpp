#include <array>

#include "results/write/layout.hpp"

/// VTKHDF 2.0, PolyData over time: https://docs.vtk.org, "VTKHDF format specification". The mesh never
/// changes, so all steps share one part, and only the offsets into points and velocities increase.
namespace trunk::layout {
namespace {

using hdf5::Axis, hdf5::create_group, hdf5::Group, hdf5::write_array, hdf5::write_count_axis;
using Numbers = std::vector<std::int64_t>;

/// The kinds of cells in the order of VTK, which is also the order of cell data.
constexpr std::array kinds = {"Vertices", "Lines", "Polygons", "Strips"};

template <class Cells>
void write_kind(hid_t vtk, const char* kind, const Cells& cells, const Axis& part) {
  Numbers offsets{0}, corners;
  for (const auto& cell : cells) {
    corners.insert(corners.end(), cell.begin(), cell.end());
    offsets.push_back(static_cast<std::int64_t>(corners.size()));
  }
  const Group group = create_group(vtk, kind);
  const Axis offset = write_count_axis(group, {"offset", "1", "cell, and one more"}, offsets.size());
  const Axis corner = write_count_axis(group, {"corner", "1", "corner of a cell"}, corners.size());
  const auto size = [](std::size_t n) { return Numbers{static_cast<std::int64_t>(n)}; };
  write_array(group, {"NumberOfCells", "1", ""}, size(cells.size()), {part});
  write_array(group, {"NumberOfConnectivityIds", "1", ""}, size(corners.size()), {part});
  write_array(group, {"Offsets", "1", "first corner of each cell"}, offsets, {offset});
  write_array(group, {"Connectivity", "1", "particle at each corner"}, corners, {corner});
}

void write_steps(hid_t vtk, const Trajectory& trajectory) {
  const std::size_t frames = trajectory.time_s.size();
  const Group steps = create_group(vtk, "Steps");
  hdf5::write_attribute(steps, "NSteps", static_cast<std::int64_t>(frames));
  const Axis time = write_axis(steps, {"Values", "s", "time of the frame"}, trajectory.time_s);
  const Axis kind = write_count_axis(steps, {"kind", "1", "vertices, lines, polygons, strips"}, kinds.size());
  const Numbers none(frames, 0), none_of_a_kind(frames * kinds.size(), 0);
  Numbers first_point;
  for (std::size_t frame = 0; frame < frames; ++frame)
    first_point.push_back(static_cast<std::int64_t>(frame * trajectory.particles));
  write_array(steps, {"PartOffsets", "1", ""}, none, {time});
  write_array(steps, {"PointOffsets", "1", "first point of each frame"}, first_point, {time});
  write_array(steps, {"CellOffsets", "1", ""}, none_of_a_kind, {time, kind});
  write_array(steps, {"ConnectivityIdOffsets", "1", ""}, none_of_a_kind, {time, kind});
  const Group points = create_group(steps, "PointDataOffsets"),
              cells = create_group(steps, "CellDataOffsets");
  if (!trajectory.velocity_m_s.empty()) write_array(points, {"velocity", "1", ""}, first_point, {time});
  if (!trajectory.contact.empty()) write_array(points, {"contact", "1", ""}, first_point, {time});
  if (!trajectory.region.empty()) write_array(points, {"region", "1", ""}, none, {time});
  write_array(cells, {"component", "1", ""}, none, {time});
}

/// Writes the component of each cell. Fibres have the number after those of the triangles.
void write_cell_data(hid_t vtk, const Trajectory& trajectory) {
  const auto fibre = static_cast<std::int32_t>(trajectory.component_names.size());
  std::vector<std::int32_t> component(trajectory.fibres.size(), fibre);
  component.insert(component.end(), trajectory.triangle_component.begin(),
                   trajectory.triangle_component.end());
  component.resize(trajectory.fibres.size() + trajectory.triangles.size());
  const Axis cell = write_count_axis(vtk, {"cell", "1", "lines, then polygons"}, component.size());
  std::vector<std::string> names = trajectory.component_names;
  names.emplace_back("fibre");
  write_flags(write_array(create_group(vtk, "CellData"), {"component", "1", "what the cell belongs to"},
                          component, {cell}),
              names);
}

}  // namespace

void write_vtkhdf(hid_t group, const Trajectory& trajectory) {
  if (trajectory.particles == 0) return;
  const Group vtk = create_group(group, "VTKHDF");
  constexpr std::int64_t version[] = {2, 0};
  hdf5::write_attribute(vtk, "Version", std::span<const std::int64_t>(version));
  hdf5::write_ascii_attribute(vtk, "Type", "PolyData");
  const std::size_t points = trajectory.time_s.size() * trajectory.particles;
  const Axis part = write_count_axis(vtk, {"part", "1", ""}, 1);
  const Axis point =
      write_count_axis(vtk, {"point", "1", "particles of the first frame, the second …"}, points);
  const Axis xyz = write_axis(vtk, {"xyz", "", "component"}, std::vector<std::string>{"x", "y", "z"});
  const Axis particle = write_count_axis(vtk, {"particle", "1", "particle"}, trajectory.particles);
  const auto flat = [&](hid_t where, const hdf5::Label& label, const std::string& quantity) {
    write_view(where, label, group, "particles/trajectory/" + quantity + "/value", {point, xyz});
  };
  write_array(vtk, {"NumberOfPoints", "1", ""}, Numbers{static_cast<std::int64_t>(trajectory.particles)},
              {part});
  flat(vtk, {"Points", "m", "position"}, "position");
  const Group point_data = create_group(vtk, "PointData");
  if (!trajectory.velocity_m_s.empty()) flat(point_data, {"velocity", "m s-1", "velocity"}, "velocity");
  if (!trajectory.contact.empty())
    write_view(point_data, {"contact", "1", "on the surface of the rib cage"}, group,
               "particles/trajectory/contact/value", {point});
  if (!trajectory.region.empty())
    write_array(point_data, {"region", "1", "region of the trunk"}, trajectory.region, {particle});
  write_kind(vtk, kinds[0], std::vector<std::array<std::int32_t, 1>>(), part);
  write_kind(vtk, kinds[1], trajectory.fibres, part);
  write_kind(vtk, kinds[2], trajectory.triangles, part);
  write_kind(vtk, kinds[3], std::vector<std::array<std::int32_t, 1>>(), part);
  write_cell_data(vtk, trajectory);
  write_steps(vtk, trajectory);
}

}  // namespace trunk::layout
