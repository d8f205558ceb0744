#pragma once

#include <span>
#include <vector>

#include "math/vec3.hpp"
#include "mesh/surface.hpp"

namespace trunk {

/// Returns the area of a triangle, m2.
double area_of(const Triangle& triangle, std::span<const Vec3d> position);

/// Returns the area that each particle stands for, m2: a third of the triangles around it, and 0 off the
/// surface. position: [particles] m.
std::vector<double> particle_areas(std::span<const Triangle> triangles, std::span<const Vec3d> position);

}  // namespace trunk
