#pragma once

#include <span>

#include "math/vec3.hpp"
#include "mesh/ring_table.hpp"

namespace trunk {

/// Volume enclosed by a closed surface, m3: one sixth of the sum of the corner determinants.
/// positions: [particles], m.
template <Scalar S>
S enclosed_volume(std::span<const Triangle> triangles, std::span<const Vec3<S>> positions) noexcept {
  S six_volumes(0.0);
  for (const auto& [i, j, k] : triangles) {
    const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j),
               c = static_cast<std::size_t>(k);
    six_volumes = six_volumes + dot(positions[a], cross(positions[b], positions[c]));
  }
  return S(1.0 / 6.0) * six_volumes;
}

/// Volume gradient at each ring's vertex, m2: (1/6) sum_j N_j x N_(j+1). It does not depend on the vertex
/// itself, since the volume is linear in each vertex. (rings, positions [particles]) => gradient [rings].
template <Scalar S>
void calc_volume_gradient(const RingTable& rings, std::span<const Vec3<S>> positions,
                          std::span<Vec3<S>> gradient) noexcept {
  for_each_ring(rings, [&](std::size_t ring, std::size_t, auto neighbours) {
    const auto at = [&](std::size_t j) { return positions[static_cast<std::size_t>(neighbours[j])]; };
    Vec3<S> last = at(neighbours.size() - 1), last_turned = turned(last);
    Vec3<S> sum;
    for (std::size_t j = 0; j < neighbours.size(); ++j) {
      const Vec3<S> here = at(j), here_turned = turned(here);
      sum += hadamard(last, here_turned) - hadamard(last_turned, here);
      last = here;
      last_turned = here_turned;
    }
    gradient[ring] = S(1.0 / 6.0) * turned(sum);
  });
}

}  // namespace trunk
