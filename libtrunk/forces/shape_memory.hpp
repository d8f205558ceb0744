#pragma once

#include <array>

#include "model/model.hpp"
#include "model/workspace.hpp"

namespace trunk {

/// More neighbours than any sensible mesh has; bounds the kernel's stack.
inline constexpr std::size_t max_valence = 64;

/// The local frame of a one-ring: centre G of the neighbours, unit normal n of their area vector, u toward
/// the first neighbour within the surface, v = n x u (paper, figure "local coordinate system"; u is our
/// choice). It does not depend on the particle itself.
template <Scalar S>
struct LocalFrame {
  Vec3<S> centre, u, v, n;
  S inverse_area;    // 1 / |area vector|, 1/m2
  S first_height;    // n . (N_1 - G), m
  S inverse_radius;  // 1 / distance of N_1 from the axis through G along n, 1/m
};

/// neighbours: [valence] positions in ring order, m. The valence may be a compile-time extent.
template <Scalar S, std::size_t Extent>
[[gnu::always_inline]] inline LocalFrame<S> local_frame(
    std::span<const Vec3<S>, Extent> neighbours) noexcept {
  using std::sqrt;
  const std::size_t m = neighbours.size();
  const Vec3<S> first = neighbours[0];
  Vec3<S> last = neighbours[1] - first;  // relative to the first neighbour: fewer products, less cancellation
  Vec3<S> sum = last, area;
  for (std::size_t j = 2; j < m; ++j) {
    const Vec3<S> here = neighbours[j] - first;
    area += unturned_cross(last, here);
    sum += here;
    last = here;
  }
  area = turned(area);
  LocalFrame<S> frame;
  const Vec3<S> to_first = S(-1.0 / static_cast<double>(m)) * sum;
  frame.centre = first - to_first;
  frame.inverse_area = S(1.0) / sqrt(dot(area, area));
  frame.n = frame.inverse_area * area;
  frame.first_height = dot(frame.n, to_first);
  const Vec3<S> flat = to_first - frame.first_height * frame.n;
  frame.inverse_radius = S(1.0) / sqrt(dot(flat, flat));
  frame.u = frame.inverse_radius * flat;
  frame.v = cross(frame.n, frame.u);
  return frame;
}

/// Where the particle would be at rest relative to its neighbours: T = G + x0 u + y0 v + z0 n (paper,
/// "Dynamics"; Cartesian numbers instead of two angles and a distance, so that nothing is undefined at a
/// distance of zero). Returned relative to G.
template <Scalar S>
Vec3<S> target_offset(const LocalFrame<S>& frame, const Vec3d& rest_offset) noexcept {
  return S(rest_offset.x()) * frame.u + S(rest_offset.y()) * frame.v + S(rest_offset.z()) * frame.n;
}

/// Adds the shape-memory force F = k (T - P) of one particle and its reactions on the neighbours.
/// (position, k) => force. The variational reactions are derived in README, "Design".
template <Reaction reaction, Scalar S, std::size_t Valence>
[[gnu::always_inline]] inline void add_shape_memory_of(std::size_t vertex, std::span<const int, Valence> ring,
                                                       const Vec3d& rest_offset, const S& stiffness,
                                                       std::span<const Vec3<S>> position,
                                                       std::span<Vec3<S>> force) noexcept {
  const std::size_t valence = ring.size();
  std::array<Vec3<S>, Valence == std::dynamic_extent ? max_valence : Valence> neighbours;
  for (std::size_t j = 0; j < valence; ++j) neighbours[j] = position[static_cast<std::size_t>(ring[j])];
  const auto force_on = [&](std::size_t j) -> Vec3<S>& { return force[static_cast<std::size_t>(ring[j])]; };

  const auto frame = local_frame(std::span<const Vec3<S>, Valence>(neighbours.data(), valence));
  const Vec3<S> offset = target_offset(frame, rest_offset);
  const Vec3<S> f = stiffness * (frame.centre + offset - position[vertex]);
  force[vertex] += f;

  const S share(1.0 / static_cast<double>(valence));
  if constexpr (reaction == Reaction::published) {
    for (std::size_t j = 0; j < valence; ++j) force_on(j) -= share * f;
  } else {
    const Vec3<S> torque = cross(offset, f);
    const S spin = dot(torque, frame.n);  // turns u: taken up by the first neighbour
    const Vec3<S> tilt =
        cross(torque, frame.n) - (spin * frame.first_height * frame.inverse_radius) * frame.v;
    const Vec3<S> tilt_per_area = frame.inverse_area * (tilt - dot(tilt, frame.n) * frame.n);
    const Vec3<S> spin_force = (spin * frame.inverse_radius) * frame.v;
    const Vec3<S> common = share * (f - spin_force);
    const Vec3<S> tilt_turned = turned(tilt_per_area);
    Vec3<S> previous = neighbours[valence - 1];
    for (std::size_t j = 0; j < valence; ++j) {
      const Vec3<S> chord = neighbours[j + 1 < valence ? j + 1 : 0] - previous;
      force_on(j) -= common + turned(hadamard(chord, tilt_turned) - hadamard(turned(chord), tilt_per_area));
      previous = neighbours[j];
    }
    force_on(0) -= spin_force;
  }
}

/// Adds the forces of all rings. (position, ring_stiffness) => force
template <Reaction reaction, Scalar S>
void add_shape_memory(const ShapeMemory& memory, std::span<const S> ring_stiffness,
                      std::span<const Vec3<S>> position, std::span<Vec3<S>> force) noexcept {
  for_each_ring(memory.rings, [&](std::size_t ring, std::size_t vertex, auto neighbours) {
    add_shape_memory_of<reaction, S>(vertex, neighbours, memory.rest_offset[ring], ring_stiffness[ring],
                                     position, force);
  });
}

template <Scalar S>
void add_shape_memory(const ShapeMemory& memory, std::span<const S> ring_stiffness,
                      std::span<const Vec3<S>> position, std::span<Vec3<S>> force) noexcept {
  if (memory.reaction == Reaction::variational)
    add_shape_memory<Reaction::variational, S>(memory, ring_stiffness, position, force);
  else
    add_shape_memory<Reaction::published, S>(memory, ring_stiffness, position, force);
}

/// Energy 1/2 k |P - T|^2 summed over the rings, J. The variational forces are its negative gradient.
double shape_memory_energy(const ShapeMemory& memory, std::span<const double> ring_stiffness,
                           std::span<const Vec3d> position);

/// Remembers the shape of a closed surface. rest: [particles] m. Weights: [particles].
/// Throws InputError where a ring has fewer than 3 or more than max_valence neighbours.
ShapeMemory make_shape_memory(const Surface& surface, std::span<const Vec3d> rest,
                              std::span<const double> stiffness_weight,
                              std::span<const double> abdominal_share, Reaction reaction);

}  // namespace trunk
