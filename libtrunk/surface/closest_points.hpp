#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "math/vec3.hpp"
#include "mesh/surface.hpp"

namespace trunk {

/// Finds the closest point of a triangulated surface with a tree of boxes (Eigen's KdBVH). It takes n log n
/// to build and about log n for a query. Triangles may be degenerate and edges open. Several threads may
/// query it.
class ClosestPoints {
 public:
  struct Hit {
    Vec3d point;
    int triangle;                  // index of the triangle
    std::array<double, 3> weight;  // barycentric, of the corners; exactly 0 for a corner that does not count
    double distance;               // >= 0, in the unit of the points
  };

  /// Copies what it needs. Throws InputError if there is no triangle or if an index is not that of a point.
  ClosestPoints(std::span<const Vec3d> points, std::span<const Triangle> triangles);
  ~ClosestPoints();
  ClosestPoints(ClosestPoints&&) noexcept;
  ClosestPoints& operator=(ClosestPoints&&) noexcept;

  /// Returns the point of the surface that is closest to a finite point. Among triangles that are equally
  /// close it is always the same one.
  Hit operator()(const Vec3d& p) const;

  /// Returns the closest point for each of many points. It uses all cores; the result does not depend on
  /// their number.
  std::vector<Hit> operator()(std::span<const Vec3d> points) const;

 private:
  struct Tree;
  std::unique_ptr<const Tree> tree_;
};

}  // namespace trunk
