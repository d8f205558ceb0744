#pragma once

#include "shape/run_region.hpp"
#include "surface/align.hpp"
#include "surface/distances.hpp"

namespace trunk {

/// Distances between a region of a simulated trunk and a measured surface. Lengths are in m.
struct ShapeComparison {
  std::vector<double> side;     // [particles] signed distance: positive if the particle is above or outside
  std::vector<bool> at_border;  // [particles] true if the closest point is on the border of an open surface
  double mean_side = 0.0;       // signed distance, mean over the area of the region
  double covered = 0.0;         // share of the region's area whose closest point is not on the border
  Distances to_surface, from_surface;
  Distances covered_to_surface;  // for the covered area alone; all 0 if nothing is covered
  RigidMove moved;               // the move of the surface that aligned it
};

/// Returns the signed distances of the particles, and the distances in both directions from 20,000 samples
/// spread over each area. The surface must face up or outward. With `align` the surface is first moved
/// rigidly onto the region. => surface
ShapeComparison compare_shape(const RunRegion& region, MeasuredSurface& surface, bool align);

/// A surface (moved, if it was aligned), the region that it was compared with, and the outcome.
struct ComparedSurface {
  MeasuredSurface surface;
  RunRegion region;
  ShapeComparison comparison;
};

}  // namespace trunk
