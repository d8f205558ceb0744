#include <algorithm>
#include <cmath>
#include <numeric>

#include "errors/input_error.hpp"
#include "io/scenario_file.hpp"
#include "report/contents.hpp"
#include "report/motion.hpp"

namespace trunk {
namespace {

using Json = Packed::Json;
using Frame = std::vector<Vec3d>;

struct Trajectory3D {
  std::vector<double> time_s;  // [T]
  std::vector<Frame> frames;   // [T][N] m, all finite
};

bool is_finite(const Frame& frame) {
  return std::all_of(frame.begin(), frame.end(), [](const Vec3d& x) {
    return std::isfinite(x.x()) && std::isfinite(x.y()) && std::isfinite(x.z());
  });
}

/// Up to the first frame that is not finite: a run that diverged has a beginning.
Trajectory3D trajectory_in(const StoredFile& file, const std::string& at) {
  const std::string place = at + "particles/trajectory/position/";
  const StoredArray positions = file.array(place + "value"), time = file.array(place + "time");
  Trajectory3D trajectory;
  if (positions.values.empty()) return trajectory;
  if (positions.shape.size() != 3 || positions.shape[2] != 3)
    throw InputError("is damaged: " + place + "value is not frames of particles in space");
  const std::size_t frames = positions.shape[0], particles = positions.shape[1];
  of_size(frames, time, place + "time");
  for (std::size_t t = 0; t < frames; ++t) {
    Frame frame;
    for (std::size_t i = 0; i < particles; ++i) {
      const double* x = &positions.values[3 * (t * particles + i)];
      frame.emplace_back(x[0], x[1], x[2]);
    }
    if (!is_finite(frame)) break;
    trajectory.time_s.push_back(time.values[t]);
    trajectory.frames.push_back(std::move(frame));
  }
  return trajectory;
}

/// Each `every`th frame.
Trajectory3D thinned(const Trajectory3D& all, std::size_t every) {
  Trajectory3D some;
  for (std::size_t t = 0; t < all.frames.size(); t += every) {
    some.time_s.push_back(all.time_s[t]);
    some.frames.push_back(all.frames[t]);
  }
  return some;
}

struct Box {
  double low[3], high[3];
};

/// Around the trunk at its start, as much again on every side: what leaves it is drawn at its border.
Box box_around(const Frame& start) {
  Box box{{start[0].x(), start[0].y(), start[0].z()}, {start[0].x(), start[0].y(), start[0].z()}};
  for (const Vec3d& p : start) {
    const double x[3] = {p.x(), p.y(), p.z()};
    for (int k = 0; k < 3; ++k) {
      box.low[k] = std::min(box.low[k], x[k]);
      box.high[k] = std::max(box.high[k], x[k]);
    }
  }
  for (int k = 0; k < 3; ++k) {
    const double size = box.high[k] - box.low[k];
    box.low[k] -= size;
    box.high[k] += size;
  }
  return box;
}

Json pack_positions(const Trajectory3D& trajectory, Packed& packed) {
  constexpr double steps = 32000.0;  // either way, within int16
  const Box box = box_around(trajectory.frames.front());
  double step_m = 1e-9;
  for (int k = 0; k < 3; ++k) step_m = std::max(step_m, (box.high[k] - box.low[k]) / (2.0 * steps));
  const double origin[3] = {std::midpoint(box.low[0], box.high[0]), std::midpoint(box.low[1], box.high[1]),
                            std::midpoint(box.low[2], box.high[2])};
  std::vector<std::int16_t> differences;
  std::vector<int> before(3 * trajectory.frames.front().size(), 0);
  for (const Frame& frame : trajectory.frames) {
    for (std::size_t i = 0; i < frame.size(); ++i) {
      const double x[3] = {frame[i].x(), frame[i].y(), frame[i].z()};
      for (std::size_t k = 0; k < 3; ++k) {
        const int now = static_cast<int>(std::lround(std::clamp((x[k] - origin[k]) / step_m, -steps, steps)));
        differences.push_back(
            static_cast<std::int16_t>(now - before[3 * i + k]));  // modulo 2^16, as when added up
        before[3 * i + k] = now;
      }
    }
  }
  return {{"origin_m", origin}, {"step_m", step_m}, {"differences", packed.add(differences)}};
}

/// Cells of particles, or codes; every one below `limit`.
std::vector<std::int32_t> indices(const StoredArray& array, std::size_t limit, const std::string& path) {
  std::vector<std::int32_t> out;
  for (const double v : array.values) {
    if (!(v >= 0.0 && v < static_cast<double>(limit)))
      throw InputError("is damaged: " + path + " names what does not exist");
    out.push_back(static_cast<std::int32_t>(v));
  }
  return out;
}

Json cells(const StoredFile& file, const std::string& path, std::size_t corners, std::size_t particles,
           Packed& packed) {
  const StoredArray array = file.array(path);
  if (!array.values.empty() && (array.shape.size() != 2 || (corners > 0 && array.shape[1] != corners)))
    throw InputError("is damaged: " + path + " is not a table of its kind");
  return {{"each", array.shape.size() == 2 ? array.shape[1] : 0},
          {"particles", packed.add(indices(array, particles, path))}};
}

Json coded(const StoredFile& file, const std::string& path, std::size_t size, Packed& packed) {
  const std::vector<std::string> names = file.code_names(path);
  const StoredArray array = file.array(path);
  if (array.values.empty()) return nullptr;
  return {{"names", names}, {"codes", packed.add(indices(of_size(size, array, path), names.size(), path))}};
}

Json trajectory_contents(const StoredFile& file, const std::string& at, const Trajectory3D& trajectory,
                         std::size_t most_bytes, Packed& packed) {
  const std::size_t particles = trajectory.frames.front().size();
  const std::size_t bytes = trajectory.frames.size() * particles * 3 * sizeof(std::int16_t);
  const std::size_t every = std::max<std::size_t>(1, (bytes + most_bytes - 1) / most_bytes);
  const Trajectory3D shown = thinned(trajectory, every);
  const std::string connectivity = at + "connectivity/";
  const Json triangles = cells(file, connectivity + "triangles", 3, particles, packed);
  const std::size_t triangle_count = triangles["particles"]["n"].get<std::size_t>() / 3;
  return {{"particles", particles},
          {"frames", shown.frames.size()},
          {"every", every},
          {"time", packed.add(shown.time_s)},
          {"positions", pack_positions(shown, packed)},
          {"triangles", triangles},
          {"component", coded(file, connectivity + "triangle_component", triangle_count, packed)},
          {"region", coded(file, at + "particles/trajectory/species", particles, packed)},
          {"fibres", cells(file, connectivity + "fibres", 2, particles, packed)},
          {"muscle_lines", cells(file, connectivity + "muscle_lines", 0, particles, packed)}};
}

/// From the trunk built again out of the scenario that the file carries.
Json motion_contents(const StoredFile& file, const std::string& at, const std::string& name,
                     const Trajectory3D& trajectory, Packed& packed) {
  const std::string scenario = file.text(at + "parameters/scenario_toml");
  const Trunk trunk = build_trunk(scenario_of_text(scenario, name, file.text(at + "parameters/trunk_pml")));
  if (trunk.model.particles() != trajectory.frames.front().size())
    throw InputError("its scenario and its trajectory have different numbers of particles");
  const Motion m = motion_of(trunk, trajectory.time_s, trajectory.frames);
  return {{"time", packed.add(trajectory.time_s)},
          {"delta_l_mm", packed.add(m.delta_l_mm)},
          {"delta_h_mm", packed.add(m.delta_h_mm)},
          {"delta_r_mm", packed.add(m.delta_r_mm)},
          {"excursion_right_mm", packed.add(m.excursion_right_mm)},
          {"excursion_left_mm", packed.add(m.excursion_left_mm)},
          {"support_particle", packed.add(m.support_particle)},
          {"touching", packed.add(m.touching)},
          {"fibre_activity", packed.add(m.fibre_activity)}};
}

/// Curves of more than `most` samples are thinned, and say so.
Json curve_contents(const StoredFile& file, const std::string& group, Packed& packed) {
  constexpr std::size_t most = 20000;
  const StoredArray time = file.array(group + "/time");
  if (time.values.empty()) return nullptr;
  const std::size_t size = time.values.size(), every = (size + most - 1) / most;
  const auto kept = [&](const std::vector<double>& values) {
    std::vector<double> some;
    for (std::size_t i = 0; i < values.size(); i += every) some.push_back(values[i]);
    return packed.add(some);
  };
  Json curves{{"every", every}, {"time", kept(time.values)}, {"series", Json::array()}};
  for (const std::string& name : file.datasets(group)) {
    if (name == "time" || file.attribute(group + "/" + name, "units").empty()) continue;
    const StoredArray curve = file.array(group + "/" + name);
    if (curve.shape.size() != 1) continue;
    of_size(size, curve, group + "/" + name);
    curves["series"].push_back(
        {{"name", name}, {"unit", curve.unit}, {"meaning", curve.meaning}, {"values", kept(curve.values)}});
  }
  return curves;
}

}  // namespace

Json run_contents(const StoredFile& file, const std::string& at, const std::string& name,
                  std::size_t trajectory_bytes, Packed& packed) {
  Json run{{"title", file.attribute(at.substr(0, at.find('/')), "title")},
           {"status", file.attribute(at.substr(0, at.find('/')), "status")},
           {"measures", numbers_in(file, at + "measures")},
           {"parameters", numbers_in(file, at + "parameters")},
           {"scenario", file.text(at + "parameters/scenario_toml")},
           {"curves", curve_contents(file, at + "curves", packed)},
           {"notes", Json::array()}};
  const Trajectory3D trajectory = trajectory_in(file, at);
  if (trajectory.frames.empty() || trajectory.frames.front().empty()) return run;
  run["trajectory"] = trajectory_contents(file, at, trajectory, trajectory_bytes, packed);
  try {
    run["motion"] = motion_contents(file, at, name, trajectory, packed);
  } catch (const InputError& error) {
    run["notes"].push_back(std::string("Measures over time, contact and paralysed fibres are not shown: ") +
                           error.what());
  }
  return run;
}

}  // namespace trunk
