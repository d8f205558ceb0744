#pragma once

#include "surface/measured_surface.hpp"

namespace trunk {

/// The same surface with at most so many triangles, for looking at: points of one cube of a grid become their
/// mean, triangles within a cube vanish; cubes grow until it is enough (Rossignac and Borrel 1993). A surface
/// that has no more comes back as it is. Triangles that come to lie in one place stay there once.
MeasuredSurface thinned(const MeasuredSurface& surface, std::size_t most_triangles);

}  // namespace trunk
