#pragma once

#include "surface/closest_points.hpp"

namespace trunk {

/// A rotation and a shift.
struct RigidMove {
  std::array<Vec3d, 3> rows{Vec3d(1, 0, 0), Vec3d(0, 1, 0), Vec3d(0, 0, 1)};
  Vec3d shift;
  double angle = 0.0;  // of the rotation, rad

  Vec3d operator()(const Vec3d& p) const {
    return Vec3d(dot(rows[0], p), dot(rows[1], p), dot(rows[2], p)) + shift;
  }
};

/// The rigid motion that brings a surface onto another by iterating closest points (Besl and McKay 1992) from
/// where `middle` lies on the area's middle: of samples spread over the area, 100 rounds at most. It finds
/// the best place near the start, not the best of all.
RigidMove aligned(std::span<const Vec3d> points, std::span<const Triangle> triangles, const ClosestPoints& to,
                  const Vec3d& middle);

/// Mean of a surface's points by area.
Vec3d middle_of_area(std::span<const Vec3d> points, std::span<const Triangle> triangles);

}  // namespace trunk
