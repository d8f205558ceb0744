#include "shape/run_region.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

#include "errors/input_error.hpp"
#include "mesh/volume.hpp"

namespace trunk {
namespace {

using Names = std::vector<std::string>;

constexpr const char* lung_component = "lung";

void require_trajectory(const Trajectory& t, const std::string& file) {
  if (t.particles == 0 || t.time_s.empty() || t.position_m.size() != t.time_s.size() * 3 * t.particles)
    throw InputError({file}, "has no trajectory", "a run simulated without --every 0");
  const auto there = [&](std::int32_t i) { return i >= 0 && static_cast<std::size_t>(i) < t.particles; };
  for (const auto& triangle : t.triangles)
    if (!std::all_of(triangle.begin(), triangle.end(), there))
      throw InputError({file}, "is damaged: a triangle has a corner that is no particle",
                       "a file as trunk wrote it", "simulate the run again");
  for (const double x : t.position_m)
    if (!std::isfinite(x))
      throw InputError({file}, "the run diverged: positions are not finite", "a run that completed");
}

std::vector<Vec3d> positions(const Trajectory& t, double time_s) {
  const auto after = std::lower_bound(t.time_s.begin(), t.time_s.end(), time_s);
  const auto high = static_cast<std::size_t>(std::min(after, t.time_s.end() - 1) - t.time_s.begin());
  const std::size_t low = high > 0 && t.time_s[high] > time_s ? high - 1 : high;
  const double span = t.time_s[high] - t.time_s[low],
               share = span > 0.0 ? (time_s - t.time_s[low]) / span : 0.0;
  std::vector<Vec3d> all;
  for (std::size_t i = 0; i < t.particles; ++i) {
    const auto coordinate = [&](std::size_t axis) {
      const std::size_t at = 3 * i + axis, width = 3 * t.particles;
      return std::lerp(t.position_m[low * width + at], t.position_m[high * width + at], share);
    };
    all.push_back({coordinate(0), coordinate(1), coordinate(2)});
  }
  return all;
}

std::vector<Triangle> triangles_of_component(const Trajectory& t, const std::string& name, bool is_that) {
  std::vector<Triangle> chosen;
  for (std::size_t i = 0; i < t.triangles.size() && i < t.triangle_component.size(); ++i)
    if ((t.component_names.at(static_cast<std::size_t>(t.triangle_component[i])) == name) == is_that)
      chosen.push_back({t.triangles[i][0], t.triangles[i][1], t.triangles[i][2]});
  return chosen;
}

double time_of_peak(const Trajectory& t) {
  const std::vector<Triangle> lung = triangles_of_component(t, lung_component, true);
  double largest = -HUGE_VAL, peak = t.time_s.front();
  for (const double time : t.time_s)
    if (const double volume = enclosed_volume<double>(lung, positions(t, time)); volume > largest) {
      largest = volume;
      peak = time;
    }
  return peak;
}

/// Returns the triangles whose corners are all in one of the regions.
std::vector<Triangle> triangles_within(const Trajectory& t, const Names& regions) {
  const auto within = [&](int i) {
    const std::string& name =
        t.region_names.at(static_cast<std::size_t>(t.region.at(static_cast<std::size_t>(i))));
    return std::find(regions.begin(), regions.end(), name) != regions.end();
  };
  std::vector<Triangle> chosen;
  std::set<Triangle> seen;  // the dome is in both surfaces
  for (const bool lung : {false, true})
    for (const Triangle& triangle : triangles_of_component(t, lung_component, lung)) {
      Triangle sorted = triangle;
      std::sort(sorted.begin(), sorted.end());
      if (std::all_of(triangle.begin(), triangle.end(), within) && seen.insert(sorted).second)
        chosen.push_back(triangle);
    }
  return chosen;
}

/// Returns the skin below the ribs. Its triangles reach from the costal insertion to the rim of the pelvis,
/// so a triangle with no corner in the abdominal wall is left out.
std::vector<Triangle> abdominal_skin(const Trajectory& t) {
  std::vector<Triangle> skin = triangles_within(t, {"abdominal_wall", "costal_insertion", "pelvis"});
  std::erase_if(skin, [&](const Triangle& triangle) {
    return std::none_of(triangle.begin(), triangle.end(), [&](int i) {
      return t.region_names.at(static_cast<std::size_t>(t.region.at(static_cast<std::size_t>(i)))) ==
             "abdominal_wall";
    });
  });
  return skin;
}

std::vector<Triangle> triangles_of(const std::string& name, const Trajectory& t) {
  if (name == "lung") return triangles_of_component(t, lung_component, true);
  if (name == "abdomen") return triangles_of_component(t, lung_component, false);
  if (name == "skin") return abdominal_skin(t);
  if (name == "diaphragm")
    return triangles_within(t, {"costal_insertion", "zone_of_apposition", "muscular_dome", "central_tendon"});
  return triangles_within(t, {name});
}

}  // namespace

double moment_of(const std::string& at, const Trajectory& t, const std::string& file) {
  require_trajectory(t, file);
  if (at == "start") return t.time_s.front();
  if (at == "end") return t.time_s.back();
  if (at == "peak") return time_of_peak(t);
  double seconds = 0.0;
  const auto [end, error] = std::from_chars(at.data(), at.data() + at.size(), seconds);
  if (error != std::errc{} || end != at.data() + at.size() ||
      !(seconds >= t.time_s.front() && seconds <= t.time_s.back()))
    throw InputError({file}, fmt::format("there is no moment '{}'", at.substr(0, 40)),
                     fmt::format("peak, start, end or {:g} to {:g} s", t.time_s.front(), t.time_s.back()));
  return seconds;
}

RunRegion region_at(const std::string& name, double time_s, const Trajectory& t, const std::string& file) {
  require_trajectory(t, file);
  RunRegion region{name, time_s, {}, {}, triangles_of(name, t), t.particles};
  if (region.triangles.empty())
    throw InputError(
        {file}, fmt::format("region '{}' has no triangle", name.substr(0, 40)),
        fmt::format("diaphragm, lung, abdomen, skin or one of {}", fmt::join(t.region_names, ", ")));
  const std::vector<Vec3d> all = positions(t, time_s);
  std::vector<int> number(t.particles, -1);
  for (const Triangle& triangle : region.triangles)
    for (const int i : triangle) number[static_cast<std::size_t>(i)] = 0;
  for (std::size_t i = 0; i < t.particles; ++i) {
    if (number[i] < 0) continue;
    number[i] = static_cast<int>(region.particles.size());
    region.particles.push_back(static_cast<int>(i));
    region.points.push_back(all[i]);
  }
  for (Triangle& triangle : region.triangles)
    for (int& i : triangle) i = number[static_cast<std::size_t>(i)];
  return region;
}

}  // namespace trunk
