#pragma once

#include <array>
#include <span>
#include <vector>

#include "math/vec3.hpp"
#include "mesh/surface.hpp"

namespace trunk {

/// A point of a triangulated surface that moves with it, and the area that it represents.
struct SurfaceSample {
  int triangle;
  std::array<double, 3> weight;  // of the triangle's corners
  double area;                   // m2

  /// Returns where the sample is. points: [points] m.
  Vec3d in(std::span<const Vec3d> points, std::span<const Triangle> triangles) const;
};

/// Returns samples: each triangle is cut into n^2 equal ones, with edges up to about `spacing`, m, and the
/// centroid of each is a sample.
std::vector<SurfaceSample> surface_samples(std::span<const Vec3d> points, std::span<const Triangle> triangles,
                                           double spacing);

/// Returns the area of a surface, m2.
double surface_area(std::span<const Vec3d> points, std::span<const Triangle> triangles);

/// Returns the unit normal of a triangle; zero if it has no area.
Vec3d unit_normal(std::span<const Vec3d> points, const Triangle& triangle);

}  // namespace trunk
