#pragma once

#include <set>

#include "surface/closest_points.hpp"
#include "surface/measured_surface.hpp"

namespace trunk {

/// A measured surface that is asked for closest points, and knows where it ends.
class TargetSurface {
 public:
  /// The surface outlives it. Throws InputError as ClosestPoints does.
  explicit TargetSurface(const MeasuredSurface& surface);

  std::vector<ClosestPoints::Hit> closest(std::span<const Vec3d> points) const { return closest_(points); }
  ClosestPoints::Hit closest(const Vec3d& p) const { return closest_(p); }

  /// Whether the point lies on the border of an open surface: what is closest to it may have no counterpart.
  bool on_border(const ClosestPoints::Hit& hit) const;

  /// Whether the data end before `from`, a point of a surface that faces along `normal` and whose closest
  /// point this is: it is on the border, or in a triangle of a jagged border, whose spikes reach beyond it,
  /// and lies farther along the surface than over it (our choice).
  bool ends_before(const Vec3d& from, const Vec3d& normal, const ClosestPoints::Hit& hit) const;

  /// Of unit length; zero where the triangle has no area.
  Vec3d normal(const ClosestPoints::Hit& hit) const;

  bool closed() const noexcept { return edges_.empty(); }

  const MeasuredSurface& surface() const noexcept { return *surface_; }

 private:
  const Triangle& triangle(const ClosestPoints::Hit& hit) const;

  const MeasuredSurface* surface_;
  ClosestPoints closest_;
  std::set<std::pair<int, int>> edges_;  // of one triangle only, sorted
  std::vector<bool> at_border_;          // [points] an end of those
};

}  // namespace trunk
