#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "math/vec3.hpp"
#include "mesh/surface.hpp"

namespace trunk {

/// The closest point of a triangulated surface, by a tree of boxes (Eigen's KdBVH): n log n to build, about
/// log n a query. Triangles may be degenerate, edges open. Safe to query from several threads.
class ClosestPoints {
 public:
  struct Hit {
    Vec3d point;
    int triangle;                  // its index
    std::array<double, 3> weight;  // of the triangle's corners, barycentric; exactly 0 off an edge or corner
    double distance;               // >= 0, in the unit of the points
  };

  /// Copies what it needs. Throws InputError without a triangle, or where an index is no point.
  ClosestPoints(std::span<const Vec3d> points, std::span<const Triangle> triangles);
  ~ClosestPoints();
  ClosestPoints(ClosestPoints&&) noexcept;
  ClosestPoints& operator=(ClosestPoints&&) noexcept;

  /// Of the whole surface to a finite point. Among equally close triangles always the same one.
  Hit operator()(const Vec3d& p) const;

  /// To each of many points, on all cores; the same for any number of them.
  std::vector<Hit> operator()(std::span<const Vec3d> points) const;

 private:
  struct Tree;
  std::unique_ptr<const Tree> tree_;
};

}  // namespace trunk
