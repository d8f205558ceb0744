#pragma once

#include <optional>
#include <span>
#include <vector>

#include "math/vec3.hpp"

namespace trunk {

/// What the lower border of a measured diaphragm is.
///  - insertion: where the diaphragm inserts on the ribs.
///  - cut: where the data end; the diaphragm goes on below.
///  - automatic: the first where that line goes around and its lower quarter is in the lower half of the
///  aligned
///    trunk's zone of apposition.
enum class LowerBorder { automatic, insertion, cut };

/// The line around the trunk along which a measured diaphragm ends below: its lowest points by the angle
/// around the trunk, which needs no border, so that thin closed sheets have one too. The ribs' margin is
/// smooth and rises in front: what does not lie on such a curve (robust fit of a plane, a sag at the sides
/// and a rise in front) is a gap in the data and left out, as the notch at the spine is. A rise in front
/// beyond `highest_rise` is a gap, too (our choice throughout; on the diaphragm of Craighero et al. 2005 the
/// curve is within 12 mm).
class InsertionLine {
 public:
  /// points: [n] m, z up, dense on the surface. centre, half_width, half_depth: of the ellipse that angles
  /// refer to.
  InsertionLine(std::span<const Vec3d> points, const Vec3d& centre, double half_width, double half_depth,
                double highest_rise);

  struct Place {
    Vec3d point;            // m
    Vec3d upward, outward;  // of unit length, both across the line
  };
  /// Where the line passes at the angle of a particle: straight across gaps of up to 45 degrees, none in
  /// wider ones.
  std::optional<Place> beside(const Vec3d& particle) const;

  /// Height of the smooth curve at that angle, m; across gaps too.
  double height_beside(const Vec3d& particle) const;

  double covered() const;     ///< part of the way around, 0 to 1
  double low_height() const;  ///< m; a quarter of what is covered is lower

 private:
  double turns(const Vec3d& p) const;  // 0 to 1
  /// From a sector on, forward or backward, how many sectors farther the next measured one is; 0: this one.
  std::optional<std::size_t> measured_within_gap(std::size_t sector, bool forward) const;

  Vec3d centre_;
  double half_width_, half_depth_;
  std::vector<std::optional<Vec3d>> lowest_;  // [sectors] around the trunk
  std::vector<double> curve_;                 // coefficients of the smooth curve, m
};

}  // namespace trunk
