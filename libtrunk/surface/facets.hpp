#pragma once

#include <vector>

#include "math/vec3.hpp"
#include "mesh/surface.hpp"

/// Geometry of one triangle among points. Private to the surface layer.
namespace trunk {

inline const Vec3d& point_of(const std::vector<Vec3d>& points, int i) {
  return points[static_cast<std::size_t>(i)];
}

/// Returns a vector as long as the area, towards the side that the triangle faces.
inline Vec3d area_vector(const std::vector<Vec3d>& points, const Triangle& t) {
  const Vec3d& a = point_of(points, t[0]);
  return 0.5 * cross(point_of(points, t[1]) - a, point_of(points, t[2]) - a);
}

inline Vec3d centre_of(const std::vector<Vec3d>& points, const Triangle& t) {
  return (1.0 / 3.0) * (point_of(points, t[0]) + point_of(points, t[1]) + point_of(points, t[2]));
}

}  // namespace trunk
