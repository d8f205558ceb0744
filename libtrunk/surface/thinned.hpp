#pragma once

#include "surface/measured_surface.hpp"

namespace trunk {

/// Returns the surface with at most `most_triangles` triangles, for display (vertex clustering, Rossignac and
/// Borrel 1993). The points in one cube of a grid become their mean, and triangles within a cube vanish; the
/// cubes grow until few enough triangles are left. Of triangles in one place only one stays. A surface that
/// is small enough is returned unchanged.
MeasuredSurface thinned(const MeasuredSurface& surface, std::size_t most_triangles);

}  // namespace trunk
