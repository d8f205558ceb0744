#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "results/records.hpp"
#include "surface/measured_surface.hpp"

namespace trunk {

/// A part of a simulated trunk at one time, as a surface.
struct RunRegion {
  std::string name;
  double time_s = 0.0;
  std::vector<int> particles;  // [points] indices of the particles in the run
  std::vector<Vec3d> points;   // [points] m
  std::vector<Triangle> triangles;
  std::size_t particles_of_run = 0;  // how many particles the run has
};

/// Returns the time (s) of "start", "end", "peak" (the largest lung volume of the trajectory), or of a number
/// of seconds within the trajectory. Throws InputError at `file` if the text is anything else, or if the
/// trajectory is missing, damaged or not finite.
double moment_of(const std::string& at, const Trajectory& trajectory, const std::string& file);

/// Returns the surface of a region: diaphragm (costal insertion, zone of apposition, muscular dome and
/// central tendon), lung, abdomen, skin (the abdominal wall between pelvis and costal insertion), or all
/// triangles whose corners are in the mesh's region of that name. Positions are interpolated linearly between
/// frames. Throws InputError with the known names if no triangle is in the region.
RunRegion region_at(const std::string& name, double time_s, const Trajectory& trajectory,
                    const std::string& file);

}  // namespace trunk
