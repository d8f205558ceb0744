#pragma once

#include "surface/measured_surface.hpp"

namespace trunk {

/// Triangles refer to the first of the points that are nearer than the tolerance to each other; the others
/// stay, without triangle. => how many those are
std::size_t merge_points(MeasuredSurface& surface, double tolerance);

}  // namespace trunk
