#include "results/write/write_run.hpp"

#include "results/write/layout.hpp"

namespace trunk {
namespace {

using hdf5::Axis, hdf5::create_group, hdf5::Group, hdf5::write_attribute;

void write_curves(hid_t group, const RunRecord& run) {
  const Group curves = create_group(group, "curves");
  const Axis time = write_axis(curves, {"time", "s", "time"}, run.curve_time_s);
  for (const Series& curve : run.curves) {
    hdf5::write_array(curves, {curve.name, layout::file_unit(curve.unit), curve.meaning}, curve.values,
                      {time});
  }
}

/// H5MD keeps here what was sampled with the frames, and nothing else.
void write_observables(hid_t group, const RunRecord& run) {
  if (run.trajectory.particles == 0 || run.frame_series.empty()) return;
  const Group observables = create_group(group, "observables");
  for (const Series& series : run.frame_series) {
    const Group one = create_group(observables, series.name);
    hdf5::link_again(group, "particles/trajectory/position/step", one, "step");
    hdf5::link_again(group, "particles/trajectory/position/time", one, "time");
    const Axis time{hdf5::Dataset(H5Dopen2(one, "time", H5P_DEFAULT), "open time"),
                    run.trajectory.time_s.size()};
    hdf5::write_array(one, {"value", layout::file_unit(series.unit), series.meaning}, series.values, {time});
  }
}

}  // namespace

void layout::write_run_content(hid_t group, const RunRecord& run) {
  write_attribute(group, "title", run.title);
  write_attribute(group, "status", run.status);
  write_attribute(group, "message", run.message);
  write_trajectory(group, run.trajectory, run.provenance.version);
  write_vtkhdf(group, run.trajectory);
  write_curves(group, run);
  write_observables(group, run);
  write_numbers(create_group(group, "measures"), run.measures);
  if (!run.intervals.empty()) write_numbers(create_group(group, "intervals"), run.intervals);
  write_structure(group, run.structure);
  const Group parameters = create_group(group, "parameters");
  write_text(parameters, {"scenario_toml", "", "the scenario as it was given"}, run.scenario_toml);
  if (!run.trunk_pml.empty())
    write_text(parameters, {"trunk_pml", "", "the trunk as it was given"}, run.trunk_pml);
  write_numbers(parameters, run.parameters);
}

void write_run(const std::filesystem::path& path, const RunRecord& run) {
  layout::store(path, "run", [&](hid_t root) {
    layout::write_run_content(root, run);
    layout::write_provenance(root, run.provenance);
  });
}

}  // namespace trunk
