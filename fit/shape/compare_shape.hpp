#pragma once

#include "shape/run_region.hpp"
#include "surface/align.hpp"
#include "surface/distances.hpp"

namespace trunk {

/// A part of a simulated trunk beside a measured surface. Lengths in m.
struct ShapeComparison {
  std::vector<double> side;  // [particles] signed distance: positive where the particle is above or outside
  std::vector<bool>
      at_border;           // [particles] closest to a border of an open surface: it may end too early there
  double mean_side = 0.0;  // over the area of the region
  double covered = 0.0;    // share of the region's area that is over the surface, not beside its border
  Distances to_surface, from_surface;
  Distances covered_to_surface;  // of the covered area alone; all 0 without any
  RigidMove moved;               // of the surface before all that, where it was aligned
};

/// Signed distances of the particles, and distances both ways from 20,000 samples spread over the area of
/// each; the surface faces up or outward. With `align` the surface is first moved rigidly onto the region.
ShapeComparison compare_shape(const RunRegion& region, MeasuredSurface& surface, bool align);

/// A surface where it was compared, what it was compared with, and the outcome.
struct ComparedSurface {
  MeasuredSurface surface;
  RunRegion region;
  ShapeComparison comparison;
};

}  // namespace trunk
