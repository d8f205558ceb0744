#pragma once

#include "surface/measured_surface.hpp"

namespace trunk {

/// Makes triangles refer to the first of several points that are nearer to each other than the tolerance, in
/// the unit of the points. The other points stay, without triangles. Returns the number of these.
std::size_t merge_points(MeasuredSurface& surface, double tolerance);

}  // namespace trunk
