#pragma once

#include <span>

#include "math/vec3.hpp"
#include "mesh/ring_table.hpp"

namespace trunk {

/// Returns the volume that a closed surface encloses, m3: one sixth of the sum of the corner determinants.
/// Each determinant takes the edges from the triangle's first corner, which are short, so that round-off is
/// small. positions: [particles], m.
template <Scalar S>
S enclosed_volume(std::span<const Triangle> triangles, std::span<const Vec3<S>> positions) noexcept {
  Vec3<S> six_volumes;  // by component: the sum follows once, at the end
  for (const auto& [i, j, k] : triangles) {
    const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j),
               c = static_cast<std::size_t>(k);
    six_volumes += hadamard(positions[a], cross(positions[b] - positions[a], positions[c] - positions[a]));
  }
  return S(1.0 / 6.0) * (six_volumes.x() + six_volumes.y() + six_volumes.z());
}

/// Two sums around a closed polygon of corners N.
template <Scalar S>
struct SumAndArea {
  Vec3<S> sum;         // of N_j
  Vec3<S> twice_area;  // sum of N_j x N_(j+1), m2: twice the area vector
};

/// Returns both sums. Quadrilaterals fan out from the first corner, and each is the cross product of its
/// diagonals: six corners need two products. Each corner is read once. corners: [3 or more] positions, m;
/// their number may be known at compile time.
template <Scalar S, class Corners>
[[gnu::always_inline]] inline SumAndArea<S> sum_and_twice_area(const Corners& corners) noexcept {
  const std::size_t m = corners.size();
  const Vec3<S> first = corners[0];
  Vec3<S> sum = first, area, a = corners[1];
  std::size_t k = 1;
  for (; k + 2 < m; k += 2) {
    const Vec3<S> b = corners[k + 1], c = corners[k + 2];
    sum += a;
    sum += b;
    area += unturned_cross(b - first, c - a);
    a = c;
  }
  sum += a;
  if (k + 1 < m) {
    const Vec3<S> b = corners[k + 1];
    sum += b;
    area += unturned_cross(a - first, b - first);
  }
  return {sum, turned(area)};
}

/// Returns the area sum only.
template <Scalar S, class Corners>
[[gnu::always_inline]] inline Vec3<S> twice_area(const Corners& corners) noexcept {
  return sum_and_twice_area<S>(corners).twice_area;
}

/// Returns how `twice_area` changes as the corners move along `directions`: the sum of
/// N_j x D_(j+1) + D_j x N_(j+1).
template <Scalar S, class Corners, class Directions>
[[gnu::always_inline]] inline Vec3<S> twice_area_change(const Corners& corners,
                                                        const Directions& directions) noexcept {
  const std::size_t m = corners.size();
  const auto change = [&](std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
    return unturned_cross(corners[b] - corners[a], directions[d] - directions[c]) +
           unturned_cross(directions[b] - directions[a], corners[d] - corners[c]);
  };
  Vec3<S> sum;
  std::size_t k = 1;
  for (; k + 2 < m; k += 2) sum += change(0, k + 1, k, k + 2);
  if (k + 1 < m) sum += change(0, k, 0, k + 1);
  return turned(sum);
}

/// Calculates twice the area vector of the ring around each vertex, m2. This is six times the gradient of the
/// enclosed volume with respect to the vertex. It does not depend on the position of the vertex itself, since
/// the volume is linear in each vertex.
/// (rings, positions [particles]) => twice_areas [particles]
template <Scalar S>
void calc_ring_areas(const RingTable& rings, std::span<const Vec3<S>> positions,
                     std::span<Vec3<S>> twice_areas) noexcept {
  for_each_ring(rings, [&]<std::size_t Valence>(std::size_t, std::size_t vertex,
                                                std::span<const Neighbour, Valence> neighbours) {
    twice_areas[vertex] = twice_area<S>(RingPositions<S, Valence>{neighbours, positions});
  });
}

}  // namespace trunk
