#pragma once

#include "surface/closest_points.hpp"

namespace trunk {

/// A rotation and a shift.
struct RigidMove {
  std::array<Vec3d, 3> rows{Vec3d(1, 0, 0), Vec3d(0, 1, 0), Vec3d(0, 0, 1)};
  Vec3d shift;
  double angle = 0.0;  // rad, of the rotation

  Vec3d operator()(const Vec3d& p) const {
    return Vec3d(dot(rows[0], p), dot(rows[1], p), dot(rows[2], p)) + shift;
  }
};

/// Returns the rigid motion that brings a surface onto another, by iterated closest points (Besl and McKay
/// 1992). At the start the middle of the surface's area lies on `middle`. The samples are spread over the
/// area, and there are 100 rounds at most. The result is the best place near the start, which may not be the
/// best of all. points: [n], in the unit of `to`.
RigidMove aligned(std::span<const Vec3d> points, std::span<const Triangle> triangles, const ClosestPoints& to,
                  const Vec3d& middle);

/// Returns the mean of a surface's points, weighted by area.
Vec3d middle_of_area(std::span<const Vec3d> points, std::span<const Triangle> triangles);

}  // namespace trunk
