#include <span>

#include "results/write/layout.hpp"

namespace trunk::layout {
namespace {

using hdf5::Axis, hdf5::create_group, hdf5::Group, hdf5::write_array, hdf5::write_attribute;

void write_h5md(hid_t group, const std::string& version_of_trunk) {
  const Group h5md = create_group(group, "h5md");
  constexpr std::int32_t version[] = {1, 1};
  write_attribute(h5md, "version", std::span<const std::int32_t>(version));
  write_attribute(create_group(h5md, "author"), "name", "not given");
  const Group creator = create_group(h5md, "creator");
  write_attribute(creator, "name", "trunk");
  write_attribute(creator, "version", version_of_trunk);
}

/// The space is not periodic.
void write_box(hid_t particles) {
  const Group box = create_group(particles, "box");
  write_attribute(box, "dimension", std::int32_t{3});
  const std::vector<std::string> none(3, "none");
  hdf5::write_attribute(box, "boundary", none);
}

/// One quantity of all particles at all frames. Its unit is only in the attribute `units` of CF, because
/// readers of H5MD (MDAnalysis) reject an H5MD `unit` of metres.
struct Frames {
  Group particles;
  Axis particle, xyz;
  const Trajectory& trajectory;

  void write_first(const hdf5::Label& label, const std::vector<double>& values) const {
    const Group quantity = create_group(particles, label.name);
    const Axis time = write_axis(quantity, {"time", "s", "time of the frame"}, trajectory.time_s);
    write_array(quantity, {"step", "1", "time step of the frame"}, trajectory.step, {time});
    write_array(quantity, {"value", label.units, label.long_name}, values, {time, particle, xyz});
  }

  void write_more(const hdf5::Label& label, const std::vector<double>& values) const {
    if (values.empty()) return;
    const Group quantity = beside_position(label.name);
    const Axis time = time_of(quantity);
    write_array(quantity, {"value", label.units, label.long_name}, values, {time, particle, xyz});
  }

  void write_codes(const hdf5::Label& label, const std::vector<std::int32_t>& codes,
                   const std::vector<std::string>& meanings) const {
    if (codes.empty()) return;
    const Group quantity = beside_position(label.name);
    const Axis time = time_of(quantity);
    const hdf5::Label there{"value", label.units, label.long_name};
    write_flags(write_array(quantity, there, codes, {time, particle}), meanings);
  }

  Group beside_position(const std::string& name) const {
    Group quantity = create_group(particles, name);
    hdf5::link_again(particles, "position/step", quantity, "step");
    hdf5::link_again(particles, "position/time", quantity, "time");
    return quantity;
  }
  Axis time_of(hid_t quantity) const {
    return {hdf5::Dataset(H5Dopen2(quantity, "time", H5P_DEFAULT), "open time"), trajectory.time_s.size()};
  }
};

void write_particles(hid_t group, const Trajectory& trajectory) {
  const Group all = create_group(group, "particles");
  Group particles = create_group(all, "trajectory");
  write_box(particles);
  Axis particle = write_count_axis(particles, {"particle", "1", "particle"}, trajectory.particles);
  Axis xyz = write_axis(particles, {"xyz", "", "component"}, std::vector<std::string>{"x", "y", "z"});
  const Frames frames{std::move(particles), std::move(particle), std::move(xyz), trajectory};
  frames.write_first({"position", "m", "position"}, trajectory.position_m);
  frames.write_more({"velocity", "m s-1", "velocity"}, trajectory.velocity_m_s);
  frames.write_more({"force", "N", "force"}, trajectory.force_N);
  frames.write_codes({"contact", "1", "on the surface of the rib cage"}, trajectory.contact,
                     trajectory.contact_names);

  std::vector<std::int32_t> id(trajectory.particles);
  for (std::size_t i = 0; i < id.size(); ++i) id[i] = static_cast<std::int32_t>(i);
  write_array(frames.particles, {"id", "1", "index of the particle in the model"}, id, {frames.particle});
  if (!trajectory.mass_kg.empty()) {
    write_array(frames.particles, {"mass", "kg", "mass"}, trajectory.mass_kg, {frames.particle});
  }
  if (!trajectory.region.empty()) {
    write_flags(write_array(frames.particles, {"species", "1", "region of the trunk"}, trajectory.region,
                            {frames.particle}),
                trajectory.region_names);
  }
  if (!trajectory.rigid.empty()) {
    write_flags(write_array(frames.particles, {"rigid", "1", "rigid component that carries the particle"},
                            trajectory.rigid, {frames.particle}),
                trajectory.rigid_names);
  }
}

template <class Cell>
void write_cells(hid_t group, hid_t connectivity, const hdf5::Label& label, const Axis& cell,
                 const Axis& corner, const std::vector<Cell>& cells) {
  std::vector<std::int32_t> flat;
  for (const auto& one : cells) flat.insert(flat.end(), one.begin(), one.end());
  hdf5::refer_to(write_array(connectivity, label, flat, {cell, corner}), "particles_group", group,
                 "particles/trajectory");
}

void write_connectivity(hid_t group, const Trajectory& trajectory) {
  const Group connectivity = create_group(group, "connectivity");
  const Axis triangle =
      write_count_axis(connectivity, {"triangle", "1", "triangle"}, trajectory.triangles.size());
  const Axis corner = write_count_axis(connectivity, {"corner", "1", "corner of a triangle"}, 3);
  write_cells(group, connectivity, {"triangles", "1", "particle at each corner"}, triangle, corner,
              trajectory.triangles);
  if (!trajectory.triangle_component.empty()) {
    write_flags(write_array(connectivity, {"triangle_component", "1", "surface the triangle belongs to"},
                            trajectory.triangle_component, {triangle}),
                trajectory.component_names);
  }
  if (!trajectory.fibres.empty()) {
    const Axis fibre =
        write_count_axis(connectivity, {"fibre", "1", "muscle fibre"}, trajectory.fibres.size());
    const Axis end = write_count_axis(connectivity, {"fibre_end", "1", "end of a fibre"}, 2);
    write_cells(group, connectivity, {"fibres", "1", "particle at each end"}, fibre, end, trajectory.fibres);
    if (!trajectory.fibre_activity.empty())
      write_array(connectivity, {"fibre_activity", "1", "fraction of k_muscle, 0 if paralysed"},
                  trajectory.fibre_activity, {fibre});
  }
  if (!trajectory.muscle_lines.empty()) {
    const auto& lines = trajectory.muscle_lines;
    const Axis line =
        write_count_axis(connectivity, {"muscle_line", "1", "line of the muscle's course"}, lines.size());
    const Axis point = write_count_axis(
        connectivity, {"line_point", "1", "place on a line, from the ribs up"}, lines.front().size());
    write_cells(group, connectivity, {"muscle_lines", "1", "particle at each place of a line"}, line, point,
                lines);
  }
}

}  // namespace

void write_trajectory(hid_t group, const Trajectory& trajectory, const std::string& version_of_trunk) {
  if (trajectory.particles == 0) return;
  write_h5md(group, version_of_trunk);
  write_particles(group, trajectory);
  write_connectivity(group, trajectory);
}

}  // namespace trunk::layout
