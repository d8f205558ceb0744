#pragma once

#include "registration/linear_actuators.hpp"
#include "registration/surface_samples.hpp"
#include "registration/target_surface.hpp"

namespace trunk {

/// A measured surface that attracts a part of the trunk.
struct Attraction {
  /// Which surface's points look for closest points on the other surface.
  enum class Direction { both, part_to_target, target_to_part };
  /// Which pairs count: all, those whose surfaces face the same way, or those that face each other.
  enum class Facing { any, alike, opposed };

  const MeasuredSurface* target;
  std::vector<Triangle> part;  // of the trunk
  Direction direction = Direction::both;
  Facing facing = Facing::any;

  /// Returns whether two unit normals are within 60 degrees of the wanted facing.
  bool faces(const Vec3d& of_part, const Vec3d& of_target) const;
};

/// The linear actuators between one target and its part of the trunk. They act along the trunk's own normal,
/// and the trunk slides across it almost freely: closest points show how far a surface is off, but not where
/// along the surface a point belongs. Beyond the end of the data there are no actuators.
class Attractor {
 public:
  /// rest: [particles] m. The attraction has to outlive the attractor.
  Attractor(const Attraction& attraction, std::span<const Vec3d> rest);

  double area() const { return area_; }  ///< m2, of the part at rest

  /// Adds the actuators for a position, [particles] m. `stiffness` is the sum over all of them, N/m. Far
  /// pairs are outliers: a pair at the distance `reach`, m, counts a quarter (weight of Geman and McClure).
  /// => actuators
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
