#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "surface/closest_points.hpp"

namespace trunk {

/// How far one surface is from another, in one direction, in the unit of the points.
struct Distances {
  double mean = 0.0, rms = 0.0, median = 0.0, percentile95 = 0.0;
  double hausdorff = 0.0;  // the largest: one-sided Hausdorff distance
};

/// Of numbers that are already distances, each >= 0; all 0 of none. Percentiles are interpolated linearly
/// between the sorted numbers.
Distances statistics_of(std::vector<double> distances);

/// `count` points spread evenly over the area of a surface: as many on equal areas, by a sequence of low
/// discrepancy within (Roberts' R2), the same on every call. Empty where the area is 0.
std::vector<Vec3d> spread_over(std::span<const Vec3d> points, std::span<const Triangle> triangles,
                               std::size_t count);

/// Of points of a surface to their closest points on another: `samples` of them spread over its area; the
/// largest distance also counts the corners of its triangles.
Distances distances(std::span<const Vec3d> points, std::span<const Triangle> triangles,
                    const ClosestPoints& to, std::size_t samples = 20000);

}  // namespace trunk
