#pragma once

#include <span>
#include <vector>

#include "math/rotation.hpp"

namespace trunk {

/// A rotation and a scale, then a shift: x -> scale turn(rotation, x) + shift.
struct Similarity {
  double scale = 1.0;
  Rotation<double> rotation;
  Vec3d shift;  // m

  Vec3d operator()(const Vec3d& x) const noexcept { return scale * turn(rotation, x) + shift; }
  Vec3d inverse(const Vec3d& x) const noexcept { return (1.0 / scale) * turn_back(rotation, x - shift); }
  double angle() const noexcept;  // rad, 0 to pi
};

/// Returns the similarity that takes `from` to `to` with the least squares (Umeyama 1991). from, to: [3 or
/// more], not on a line.
Similarity fitted_similarity(std::span<const Vec3d> from, std::span<const Vec3d> to);

}  // namespace trunk
