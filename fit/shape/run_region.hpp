#pragma once

#include <string>
#include <vector>

#include "results/records.hpp"
#include "surface/measured_surface.hpp"

namespace trunk {

/// A part of a simulated trunk at one moment, as a surface.
struct RunRegion {
  std::string name;
  double time_s = 0.0;
  std::vector<int> particles;  // [points] their indices in the run
  std::vector<Vec3d> points;   // [points] m
  std::vector<Triangle> triangles;
};

/// The time (s) that a word means: "start", "end", "peak" (the largest lung volume of the trajectory), or a
/// number of seconds within the trajectory. Throws InputError, beginning with `file`.
double moment_of(const std::string& at, const Trajectory& trajectory, const std::string& file);

/// The triangles of a region: diaphragm (costal insertion, zone of apposition, muscular dome, central
/// tendon), lung, abdomen, skin (the abdominal wall between pelvis and costal insertion), or all whose
/// corners are in the region of that name. Positions are linear between frames. Throws InputError, naming
/// what is known.
RunRegion region_at(const std::string& name, double time_s, const Trajectory& trajectory,
                    const std::string& file);

}  // namespace trunk
