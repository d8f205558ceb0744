#pragma once

#include "mesh/volume.hpp"

namespace trunk {

/// Returns the triangles grouped in fans; each triangle is in one fan. A fan is a centre C with a closed
/// polygon of corners N around it, so that C . twice_area(N) is the sum of the fan's corner determinants. The
/// polygon of an open fan passes through its centre, which adds nothing. About a third of a surface's
/// particles are centres, and two or more triangles share a cross product: a sum over fans costs three to
/// four times less than a sum over triangles. Polygons have 4, 6 or 8 corners; the last corner is repeated
/// where one is missing.
RingTable fans(std::span<const Triangle> triangles);

/// Returns the share of the triangles in the enclosed volume, m3; for all triangles of a closed surface this
/// is the volume that it encloses. positions: [particles], m.
template <Scalar S>
S volume_of_fans(const RingTable& fans, std::span<const Vec3<S>> positions) noexcept {
  Vec3<S> six_volumes;  // by component: the sum follows once, at the end
  for_each_ring(fans, [&]<std::size_t Valence>(std::size_t, std::size_t centre,
                                               std::span<const Neighbour, Valence> polygon) {
    six_volumes += hadamard(positions[centre], twice_area<S>(RingPositions<S, Valence>{polygon, positions}));
  });
  return S(1.0 / 6.0) * (six_volumes.x() + six_volumes.y() + six_volumes.z());
}

/// Twice the area vector of a closed polygon whose corners move. With the corners at N + lambda D it is
/// at + lambda change + lambda^2 along.
template <Scalar S>
struct AreaAlong {
  Vec3<S> at, change, along;
};

/// Returns how twice the area vector of a polygon changes along directions. corners, directions: [4 or more,
/// an even number].
template <Scalar S, class Corners, class Directions>
[[gnu::always_inline]] inline AreaAlong<S> twice_area_along(const Corners& corners,
                                                            const Directions& directions) noexcept {
  AreaAlong<S> sum;
  const Vec3<S> first = corners[0], first_direction = directions[0];
  for (std::size_t k = 1; k + 2 < corners.size(); k += 2) {
    const Vec3<S> across = corners[k + 1] - first, along = corners[k + 2] - corners[k];
    const Vec3<S> turning = directions[k + 1] - first_direction, growing = directions[k + 2] - directions[k];
    sum.at += unturned_cross(across, along);
    sum.change += unturned_cross(across, growing) + unturned_cross(turning, along);
    sum.along += unturned_cross(turning, growing);
  }
  return {turned(sum.at), turned(sum.change), turned(sum.along)};
}

}  // namespace trunk
