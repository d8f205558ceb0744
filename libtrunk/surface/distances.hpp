#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "surface/closest_points.hpp"

namespace trunk {

/// Statistics of the distances from one surface to another, in one direction, in the unit of the points.
struct Distances {
  double mean = 0.0, rms = 0.0, median = 0.0, percentile95 = 0.0;
  double hausdorff = 0.0;  // the largest: one-sided Hausdorff distance
};

/// Returns the statistics of distances, each >= 0; all are 0 if there are none. Percentiles are interpolated
/// linearly between the sorted numbers.
Distances statistics_of(std::vector<double> distances);

/// Returns `count` points spread evenly over the area of a surface, the same on every call; none if the area
/// is 0. Equal areas get equal numbers of points; within a triangle they follow a sequence of low discrepancy
/// (Roberts' R2).
std::vector<Vec3d> spread_over(std::span<const Vec3d> points, std::span<const Triangle> triangles,
                               std::size_t count);

/// Returns the statistics of the distances from points of a surface to their closest points on another. The
/// points are `samples` points spread over its area; the largest distance also counts the corners of its
/// triangles.
Distances distances(std::span<const Vec3d> points, std::span<const Triangle> triangles,
                    const ClosestPoints& to, std::size_t samples = 20000);

}  // namespace trunk
