#pragma once

#include <span>
#include <vector>

#include "math/vec3.hpp"

namespace trunk {

/// Returns the weights of a ring's neighbours that make it as round as it can be, [neighbours], with the sum
/// 1 (our choice). Let q be the places of the neighbours within the surface, relative to the particle and
/// scaled to an RMS of 1. The weighted centre should lie over the particle, and the second moment should be
/// the same in all directions, so the weights minimise
///   900 [(sum w - 1)^2 + |sum w q|^2] + (sum w (q1^2 - q2^2))^2 + (2 sum w q1 q2)^2 + 0.15^2 |w - 1/m|^2
/// with w >= 0.15/m, and are then divided by their sum. Without the bound, degenerate rings get weights that
/// are large and negative. offset: N_j - P at rest, m; normal: of the ring, a unit vector.
std::vector<double> ring_weights(std::span<const Vec3d> offset, const Vec3d& normal);

}  // namespace trunk
