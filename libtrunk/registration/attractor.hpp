#pragma once

#include "registration/linear_actuators.hpp"
#include "registration/surface_samples.hpp"
#include "registration/target_surface.hpp"

namespace trunk {

/// A measured surface that draws a part of the trunk.
struct Attraction {
  /// Which of the two has its place on the other: points of the part are drawn to the target, points of the
  /// target draw the part, or both.
  enum class Direction { both, part_to_target, target_to_part };
  /// Pairs count only where their surfaces face alike, or against each other.
  enum class Facing { any, alike, opposed };

  const MeasuredSurface* target;
  std::vector<Triangle> part;  // of the trunk
  Direction direction = Direction::both;
  Facing facing = Facing::any;

  /// Of two unit normals: within 60 degrees of what is wanted.
  bool faces(const Vec3d& of_part, const Vec3d& of_target) const;
};

/// The linear actuators of one target and its part of the trunk. They draw along the trunk's own normal, and
/// the trunk slides across it nearly free: closest points tell how far a surface is off, not where along it a
/// point belongs. Where the data end nothing is drawn.
class Attractor {
 public:
  /// rest: [particles] m. The attraction outlives it.
  Attractor(const Attraction& attraction, std::span<const Vec3d> rest);

  double area() const { return area_; }  ///< m2, of the part at rest

  /// `stiffness` is that of all together, N/m. A pair as far apart as `reach`, m, counts a quarter (weight of
  /// Geman and McClure): outliers. => actuators
  void add_to(std::vector<LinearActuator>& actuators, std::span<const Vec3d> position, double stiffness,
              double reach) const;

 private:
  const Attraction& attraction_;
  TargetSurface target_;
  double area_;
  std::vector<SurfaceSample> samples_;   // of the part
  std::vector<Vec3d> points_, normals_;  // of the target
};

}  // namespace trunk
