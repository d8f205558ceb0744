#pragma once

#include <map>
#include <utility>
#include <vector>

#include "surface/closest_points.hpp"

namespace trunk {

/// Distance with a sign: positive on the side that the surface faces. The sign comes from the angle-weighted
/// normal of the closest face, edge or corner, which is exact for a closed surface (Baerentzen and Aanaes
/// 2005). Beside the border of an open surface it is the side of the border's tangent plane. The surface has
/// to be oriented, and corners in one place have to be one point.
class SignedDistance {
 public:
  /// Copies what it needs. Throws InputError if there is no triangle or if an index is not that of a point.
  SignedDistance(std::span<const Vec3d> points, std::span<const Triangle> triangles);

  struct Hit : ClosestPoints::Hit {
    double side;     // the distance with its sign
    bool at_border;  // the closest point is on the border: the point is beside an open surface, not over it
  };
  /// Returns the signed distance of a finite point, in the unit of the points.
  Hit operator()(const Vec3d& p) const;

  const ClosestPoints& closest() const noexcept { return closest_; }

 private:
  /// The face, edge or corner that a closest point is on.
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
