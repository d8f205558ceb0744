#pragma once

#include <array>
#include <span>
#include <vector>

#include "math/vec3.hpp"
#include "mesh/surface.hpp"

namespace trunk {

/// A point of a triangulated surface that moves with it, and the area it stands for.
struct SurfaceSample {
  int triangle;
  std::array<double, 3> weight;  // of the triangle's corners
  double area;                   // m2

  Vec3d in(std::span<const Vec3d> points, std::span<const Triangle> triangles) const;
};

/// Each triangle cut into n^2 equal ones no longer than about `spacing`, the centroid of each a sample.
std::vector<SurfaceSample> surface_samples(std::span<const Vec3d> points, std::span<const Triangle> triangles,
                                           double spacing);

double surface_area(std::span<const Vec3d> points, std::span<const Triangle> triangles);

/// Unit normal of a triangle; zero where it has no area.
Vec3d unit_normal(std::span<const Vec3d> points, const Triangle& triangle);

}  // namespace trunk
