#pragma once

#include <set>

#include "surface/closest_points.hpp"
#include "surface/measured_surface.hpp"

namespace trunk {

/// A measured surface that is asked for closest points, and knows where it ends.
class MeasuredTarget {
 public:
  /// The surface outlives it. Throws InputError as ClosestPoints does.
  explicit MeasuredTarget(const MeasuredSurface& surface);

  ClosestPoints::Hit closest(const Vec3d& p) const { return closest_(p); }

  /// Whether the point lies on the border of an open surface: what is closest to it may have no counterpart.
  bool on_border(const ClosestPoints::Hit& hit) const;

  const MeasuredSurface& surface() const noexcept { return *surface_; }

 private:
  const MeasuredSurface* surface_;
  ClosestPoints closest_;
  std::set<std::pair<int, int>> edges_;  // of one triangle only, sorted
  std::set<int> points_;                 // their ends
};

}  // namespace trunk
