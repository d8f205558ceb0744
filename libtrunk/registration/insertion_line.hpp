#pragma once

#include <optional>
#include <span>
#include <vector>

#include "math/vec3.hpp"

namespace trunk {

/// The meaning of the lower border of a measured diaphragm.
///  - insertion: the diaphragm inserts on the ribs there.
///  - cut: the data end there, and the diaphragm goes on below.
///  - automatic: `insertion` if the border goes around the trunk and its lower quarter is in the lower half
///    of the aligned trunk's zone of apposition, else `cut`.
enum class LowerBorder { automatic, insertion, cut };

/// The line around the trunk along which a measured diaphragm ends below: its lowest points by the angle
/// around the trunk. It needs no border, so that thin closed sheets have such a line too. The margin of the
/// ribs is smooth and rises in front. Points off such a curve (robust fit of a plane, a sag at the sides and
/// a rise in front) are gaps in the data and left out, like the notch at the spine. A rise in front beyond
/// `highest_rise`, m, is a gap, too. All of this is our choice; on the diaphragm of Craighero et al. 2005 the
/// curve is within 12 mm.
class InsertionLine {
 public:
  /// points: [n] m, z up, dense on the surface. centre, half_width, half_depth: of the ellipse by which
  /// angles are measured. Throws InputError if there are no points.
  InsertionLine(std::span<const Vec3d> points, const Vec3d& centre, double half_width, double half_depth,
                double highest_rise);

  /// A point of the line.
  struct LinePoint {
    Vec3d point;            // m
    Vec3d upward, outward;  // of unit length, both perpendicular to the line
  };
  /// Returns the point of the line at the angle of a particle. The line is straight across gaps of up to 45
  /// degrees; there is no point in a wider gap.
  std::optional<LinePoint> beside(const Vec3d& particle) const;

  /// Returns the height of the smooth curve at that angle, m, also in gaps.
  double height_beside(const Vec3d& particle) const;

  /// Returns the share of the way around that the line covers, 0 to 1.
  double covered() const;
  /// Returns the height below which a quarter of the covered line lies, m.
  double low_height() const;

 private:
  double turns(const Vec3d& p) const;  // 0 to 1
  /// Returns how many sectors forward or backward of a sector the next measured one is; 0: the sector itself.
  std::optional<std::size_t> measured_within_gap(std::size_t sector, bool forward) const;

  Vec3d centre_;
  double half_width_, half_depth_;
  std::vector<std::optional<Vec3d>> lowest_;  // [sectors] around the trunk
  std::vector<double> curve_;                 // coefficients of the smooth curve, m
};

}  // namespace trunk
