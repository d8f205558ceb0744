#include "results/run_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "results/layout.hpp"

namespace trunk {
namespace {

using hdf5::Axis, hdf5::create_group, hdf5::Group, hdf5::write_attribute;

/// The curve at the moments of the frames, linear between its samples; NaN outside of them.
std::vector<double> at_frames(const std::vector<double>& time_s, const std::vector<double>& values,
                              const std::vector<double>& frames_s) {
  constexpr double round_off_s = 1e-9;
  std::vector<double> sampled;
  for (const double frame : frames_s) {
    if (frame < time_s.front() - round_off_s || frame > time_s.back() + round_off_s) {
      sampled.push_back(std::numeric_limits<double>::quiet_NaN());
      continue;
    }
    const auto after = std::upper_bound(time_s.begin(), time_s.end(), frame);
    const auto next = std::clamp<std::ptrdiff_t>(after - time_s.begin(), 1, std::ssize(time_s) - 1);
    const auto right = static_cast<std::size_t>(next), left = right - 1;
    const double weight = std::clamp((frame - time_s[left]) / (time_s[right] - time_s[left]), 0.0, 1.0);
    sampled.push_back(std::lerp(values[left], values[right], weight));
  }
  return sampled;
}

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
  const auto is_volume = [](const Series& curve) { return curve.name == "dV_model"; };
  const auto curve = std::find_if(run.curves.begin(), run.curves.end(), is_volume);
  const Trajectory& trajectory = run.trajectory;
  if (curve == run.curves.end() || trajectory.particles == 0 || run.curve_time_s.size() < 2) return;
  const Group observables = create_group(group, "observables");
  const Group volume = create_group(observables, "dV");
  hdf5::link_again(group, "particles/trajectory/position/step", volume, "step");
  hdf5::link_again(group, "particles/trajectory/position/time", volume, "time");
  const Axis time{hdf5::Dataset(H5Dopen2(volume, "time", H5P_DEFAULT), "open time"),
                  trajectory.time_s.size()};
  hdf5::write_array(volume, {"value", layout::file_unit(curve->unit), curve->meaning},
                    at_frames(run.curve_time_s, curve->values, trajectory.time_s), {time});
}

}  // namespace

void layout::write_run_content(hid_t group, const RunRecord& run) {
  write_attribute(group, "title", run.title);
  write_attribute(group, "status", run.status);
  write_attribute(group, "message", run.message);
  write_trajectory(group, run.trajectory);
  write_curves(group, run);
  write_observables(group, run);
  write_numbers(create_group(group, "measures"), run.measures);
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
