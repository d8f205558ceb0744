#pragma once

#include <set>

#include "surface/closest_points.hpp"
#include "surface/measured_surface.hpp"

namespace trunk {

/// A measured surface onto which a trunk is registered. It finds closest points and the ends of the data.
class TargetSurface {
 public:
  /// The surface has to outlive the target. Throws InputError if there is no triangle or if an index is not
  /// that of a point.
  explicit TargetSurface(const MeasuredSurface& surface);

  std::vector<ClosestPoints::Hit> closest(std::span<const Vec3d> points) const { return closest_(points); }
  ClosestPoints::Hit closest(const Vec3d& p) const { return closest_(p); }

  /// Returns whether a closest point lies on the border of an open surface. A point beyond the border may
  /// have no counterpart.
  bool on_border(const ClosestPoints::Hit& hit) const;

  /// Returns whether the data end before `from`, a point of a surface that faces along `normal` (our choice).
  /// They do if its closest point, `hit`, is on the border. They also do if `hit` is in a triangle at a
  /// jagged border and `from` lies farther along the surface than over it.
  bool ends_before(const Vec3d& from, const Vec3d& normal, const ClosestPoints::Hit& hit) const;

  /// Returns the unit normal at a closest point; zero if the triangle has no area.
  Vec3d normal(const ClosestPoints::Hit& hit) const;

  bool closed() const noexcept { return edges_.empty(); }

  const MeasuredSurface& surface() const noexcept { return *surface_; }

 private:
  const Triangle& triangle(const ClosestPoints::Hit& hit) const;

  const MeasuredSurface* surface_;
  ClosestPoints closest_;
  std::set<std::pair<int, int>> edges_;  // edges of one triangle only, sorted
  std::vector<bool> at_border_;          // [points] whether an end of such an edge
};

}  // namespace trunk
