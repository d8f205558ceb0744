#pragma once

#include "report/packed.hpp"
#include "shape/compare_shape.hpp"

namespace trunk {

/// Returns what a page shows of a measured surface and a run: its triangles, thinned to 12,000 (our choice:
/// 0.4 MB of a page), the signed distance of each particle of the region that is over it (NaN for other
/// particles), and the distances in both directions. Lengths are in mm.
Packed::Json surface_contents(const ComparedSurface& compared, Packed& packed);

}  // namespace trunk
