#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "errors/input_error.hpp"
#include "report/contents.hpp"

namespace trunk {
namespace {

using Json = Packed::Json;

[[noreturn]] void damaged(const std::string& what) {
  throw InputError({}, "is damaged: " + what, "a file as trunk wrote it");
}

/// Returns the number of frames before the first that is not finite: a run that diverged still has a
/// beginning.
std::size_t finite_frames(const Trajectory& t) {
  const std::size_t width = 3 * t.particles;
  if (t.position_m.size() != t.time_s.size() * width) damaged("the positions have the wrong shape");
  const auto first =
      std::find_if_not(t.position_m.begin(), t.position_m.end(), [](double x) { return std::isfinite(x); });
  return static_cast<std::size_t>(first - t.position_m.begin()) / width;
}

/// One axis of the box that is drawn: the trunk at its start, and its width again on either side. A point
/// outside the box is drawn at its border.
struct Range {
  double middle, half;
};

Range range_of(std::span<const double> start, std::size_t axis) {
  double low = start[axis], high = start[axis];
  for (std::size_t i = axis; i < start.size(); i += 3) {
    low = std::min(low, start[i]);
    high = std::max(high, start[i]);
  }
  return {std::midpoint(low, high), 1.5 * (high - low)};
}

/// Returns every `every`-th of the first `frames` frames.
Json position_contents(const Trajectory& t, std::size_t frames, std::size_t every, Packed& packed) {
  constexpr double most_steps = 32000.0;  // either way, within int16
  const std::size_t width = 3 * t.particles;
  const std::span<const double> all(t.position_m), start = all.first(width);
  const Range range[3] = {range_of(start, 0), range_of(start, 1), range_of(start, 2)};
  const double step_m =
      std::max({1e-9, range[0].half / most_steps, range[1].half / most_steps, range[2].half / most_steps});
  std::vector<std::int16_t> differences;
  std::vector<long> before(width, 0);
  for (std::size_t frame = 0; frame < frames; frame += every)
    for (std::size_t i = 0; i < width; ++i) {
      const double steps = (all[frame * width + i] - range[i % 3].middle) / step_m;
      const long now = std::lround(std::clamp(steps, -most_steps, most_steps));
      differences.push_back(static_cast<std::int16_t>(now - before[i]));  // modulo 2^16, as when added up
      before[i] = now;
    }
  return {{"origin_m", {range[0].middle, range[1].middle, range[2].middle}},
          {"step_m", step_m},
          {"differences", packed.add(differences)}};
}

template <class Cells>
Json cell_contents(const Cells& cells, Packed& packed) {
  std::vector<std::int32_t> flat;
  for (const auto& cell : cells) flat.insert(flat.end(), cell.begin(), cell.end());
  return {{"each", cells.empty() ? 0 : cells.front().size()}, {"particles", packed.add(flat)}};
}

Json code_contents(const std::vector<std::int32_t>& codes, const std::vector<std::string>& names,
                   Packed& packed) {
  if (codes.empty()) return nullptr;
  for (const std::int32_t code : codes)
    if (code < 0 || static_cast<std::size_t>(code) >= names.size()) damaged("a code has no meaning");
  return {{"names", names}, {"codes", packed.add(codes)}};
}

/// Returns the particles that ever touch the ribs, and for each frame and each of them 1 if it touches.
Json contact_contents(const Trajectory& t, std::size_t frames, std::size_t every, Packed& packed) {
  if (t.contact.empty()) return nullptr;
  std::vector<std::int32_t> particles;
  for (std::size_t i = 0; i < t.particles; ++i) {
    bool ever = false;
    for (std::size_t frame = 0; frame < frames; ++frame)
      ever = ever || t.contact[frame * t.particles + i] != 0;
    if (ever) particles.push_back(static_cast<std::int32_t>(i));
  }
  std::vector<std::uint8_t> touching;
  for (std::size_t frame = 0; frame < frames; frame += every)
    for (const std::int32_t i : particles)
      touching.push_back(t.contact[frame * t.particles + static_cast<std::size_t>(i)] != 0 ? 1 : 0);
  return {{"particles", packed.add(particles)}, {"touching", packed.add(touching)}};
}

Json trajectory_contents(const Trajectory& t, std::size_t most_bytes, Packed& packed) {
  const std::size_t frames = t.particles == 0 ? 0 : finite_frames(t);
  if (frames == 0) return nullptr;
  const std::size_t bytes = frames * t.particles * 3 * sizeof(std::int16_t);
  const std::size_t every = std::max<std::size_t>(1, (bytes + most_bytes - 1) / most_bytes);
  std::vector<double> time_s;
  for (std::size_t frame = 0; frame < frames; frame += every) time_s.push_back(t.time_s[frame]);
  return {{"particles", t.particles},
          {"frames", time_s.size()},
          {"every", every},
          {"time", packed.add(time_s)},
          {"positions", position_contents(t, frames, every, packed)},
          {"triangles", cell_contents(t.triangles, packed)},
          {"component", code_contents(t.triangle_component, t.component_names, packed)},
          {"region", code_contents(t.region, t.region_names, packed)},
          {"fibres", cell_contents(t.fibres, packed)},
          {"fibre_activity", packed_if_any(t.fibre_activity, t.fibres.size(), "fibre_activity", packed)},
          {"muscle_lines", cell_contents(t.muscle_lines, packed)},
          {"contact", contact_contents(t, frames, every, packed)}};
}

/// Returns the curves, thinned to `most` samples; `every` tells how much.
Json curve_contents(const std::vector<double>& time_s, const std::vector<Series>& curves, Packed& packed) {
  constexpr std::size_t most = 20000;
  if (time_s.empty() || curves.empty()) return nullptr;
  const std::size_t every = (time_s.size() + most - 1) / most;
  const auto kept = [&](const std::vector<double>& values) {
    std::vector<double> some;
    for (std::size_t i = 0; i < values.size(); i += every) some.push_back(values[i]);
    return packed.add(some);
  };
  Json json{{"every", every}, {"time", kept(time_s)}, {"series", Json::array()}};
  for (const Series& curve : curves)
    json["series"].push_back({{"name", curve.name},
                              {"unit", curve.unit},
                              {"meaning", curve.meaning},
                              {"values", kept(curve.values)}});
  return json;
}

}  // namespace

Json run_contents(const RunRecord& run, std::size_t trajectory_bytes, Packed& packed) {
  return {{"status", run.status},
          {"message", run.message},
          {"scenario", run.scenario_toml},
          {"measures", json_table(run.measures)},
          {"parameters", json_table(run.parameters)},
          {"curves", curve_contents(run.curve_time_s, run.curves, packed)},
          {"frames", curve_contents(run.trajectory.time_s, run.frame_series, packed)},
          {"trajectory", trajectory_contents(run.trajectory, trajectory_bytes, packed)}};
}

}  // namespace trunk
