#pragma once

#include "report/packed.hpp"
#include "shape/compare_shape.hpp"

namespace trunk {

/// What a page shows of a measured surface beside a run: its triangles, thinned to 12,000 for looking at (our
/// choice: 0.4 MB of a page), the signed distance of each particle of the region that is over it, NaN of the
/// others, and the distances both ways. Lengths in mm.
Packed::Json surface_contents(const ComparedSurface& beside, std::size_t particles, Packed& packed);

}  // namespace trunk
