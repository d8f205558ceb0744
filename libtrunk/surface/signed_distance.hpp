#pragma once

#include <map>
#include <utility>
#include <vector>

#include "surface/closest_points.hpp"

namespace trunk {

/// Distance with the side: positive where a point lies on the side that the surface faces. The side is told
/// by the angle-weighted normal of the face, edge or corner that is closest, which is exact for a closed
/// surface (Baerentzen and Aanaes 2005); beside the border of an open one it is the side of the border's
/// tangent plane. The surface has to be oriented and its equal corners to be one point.
class SignedDistance {
 public:
  /// Copies what it needs. Errors: those of ClosestPoints.
  SignedDistance(std::span<const Vec3d> points, std::span<const Triangle> triangles);

  struct Hit : ClosestPoints::Hit {
    double side;     // the distance, or minus the distance
    bool at_border;  // the closest point is on an edge of one triangle: beside an open surface, not over it
  };
  /// Of a finite point, in the unit of the points.
  Hit operator()(const Vec3d& p) const;

  const ClosestPoints& closest() const noexcept { return closest_; }

 private:
  /// Of the face, edge or corner that a closest point is on.
  struct Feature {
    Vec3d normal;  // not of unit length
    bool border = false;
  };
  const Feature& feature_at(const ClosestPoints::Hit& hit) const;

  ClosestPoints closest_;
  std::vector<Triangle> triangles_;
  std::vector<Feature> faces_, corners_;  // [triangles], [points]
  std::map<std::pair<int, int>, Feature> edges_;
};

}  // namespace trunk
