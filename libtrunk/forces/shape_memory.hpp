#pragma once

#include <array>

#include "math/lanes.hpp"
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
Vec3<S> target_offset(const LocalFrame<S>& frame, const Vec3<S>& rest_offset) noexcept {
  return rest_offset.x() * frame.u + rest_offset.y() * frame.v + rest_offset.z() * frame.n;
}

/// The law of one ring. Returns the force F = k (T - P) on the particle; `reaction_on` [valence] gets what is
/// to be subtracted from the forces on its neighbours. The variational reactions are derived in README,
/// "Design".
template <Reaction reaction, Scalar S, std::size_t Valence>
[[gnu::always_inline]] inline Vec3<S> ring_force(std::span<const Vec3<S>, Valence> neighbours,
                                                 const Vec3<S>& particle, const Vec3<S>& rest_offset,
                                                 const S& stiffness,
                                                 std::span<Vec3<S>, Valence> reaction_on) noexcept {
  const std::size_t valence = neighbours.size();
  const auto frame = local_frame(neighbours);
  const Vec3<S> offset = target_offset(frame, rest_offset);
  const Vec3<S> f = stiffness * (frame.centre + offset - particle);

  const S share(1.0 / static_cast<double>(valence));
  if constexpr (reaction == Reaction::published) {
    for (std::size_t j = 0; j < valence; ++j) reaction_on[j] = share * f;
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
      reaction_on[j] = common + turned(hadamard(chord, tilt_turned) - hadamard(turned(chord), tilt_per_area));
      previous = neighbours[j];
    }
    reaction_on[0] += spin_force;
  }
  return f;
}

template <Scalar S, std::size_t Valence>
using RingVectors = std::array<Vec3<S>, Valence == std::dynamic_extent ? max_valence : Valence>;

/// Adds the forces of one ring. (position, k) => force
template <Reaction reaction, Scalar S, std::size_t Valence>
void add_ring(std::size_t vertex, std::span<const int, Valence> ring, const Vec3d& rest_offset,
              const S& stiffness, std::span<const Vec3<S>> position, std::span<Vec3<S>> force) noexcept {
  RingVectors<S, Valence> neighbours, reaction_on;
  for (std::size_t j = 0; j < ring.size(); ++j) neighbours[j] = position[static_cast<std::size_t>(ring[j])];
  force[vertex] += ring_force<reaction, S, Valence>(
      std::span<const Vec3<S>, Valence>(neighbours.data(), ring.size()), position[vertex],
      lift<S>(rest_offset), stiffness, std::span<Vec3<S>, Valence>(reaction_on.data(), ring.size()));
  for (std::size_t j = 0; j < ring.size(); ++j) force[static_cast<std::size_t>(ring[j])] -= reaction_on[j];
}

/// Adds the forces of four rings of one valence, from `ring` on, side by side in the lanes of a register.
template <Reaction reaction, std::size_t Valence>
void add_four_rings(const ShapeMemory& memory, const RingTable::Group& group, int ring,
                    std::span<const double> stiffness, std::span<const Vec3d> position,
                    std::span<Vec3d> force) noexcept {
  const RingTable& rings = memory.rings;
  const auto row = static_cast<std::size_t>(ring);
  const int* neighbour = neighbours_of<Valence>(rings, group, ring).data();
  const auto vertex = [&](std::size_t lane) { return static_cast<std::size_t>(rings.vertex[row + lane]); };
  const auto in_ring = [&](std::size_t lane, std::size_t j) {
    return static_cast<std::size_t>(neighbour[lane * Valence + j]);
  };
  std::array<Vec3<Lanes4>, Valence> neighbours, reaction_on;
  for (std::size_t j = 0; j < Valence; ++j)
    neighbours[j] = packed(position[in_ring(0, j)], position[in_ring(1, j)], position[in_ring(2, j)],
                           position[in_ring(3, j)]);
  const auto& rest = memory.rest_offset;
  const Vec3<Lanes4> f = ring_force<reaction, Lanes4, Valence>(
      std::span<const Vec3<Lanes4>, Valence>(neighbours),
      packed(position[vertex(0)], position[vertex(1)], position[vertex(2)], position[vertex(3)]),
      packed(rest[row], rest[row + 1], rest[row + 2], rest[row + 3]),
      Lanes4(stiffness[row], stiffness[row + 1], stiffness[row + 2], stiffness[row + 3]),
      std::span<Vec3<Lanes4>, Valence>(reaction_on));
  const Unpacked on_vertex = unpacked(f);
  for (std::size_t lane = 0; lane < 4; ++lane) force[vertex(lane)] += on_vertex.lane[lane];
  for (std::size_t j = 0; j < Valence; ++j) {
    const Unpacked reaction_force = unpacked(reaction_on[j]);
    for (std::size_t lane = 0; lane < 4; ++lane) force[in_ring(lane, j)] -= reaction_force.lane[lane];
  }
}

/// Adds the forces of all rings. (position, ring_stiffness) => force
template <Reaction reaction, Scalar S>
void add_shape_memory(const ShapeMemory& memory, std::span<const S> ring_stiffness,
                      std::span<const Vec3<S>> position, std::span<Vec3<S>> force) noexcept {
  for_each_valence(memory.rings, [&]<std::size_t Valence>(const RingTable::Group& group) {
    int ring = group.first;
    if constexpr (std::same_as<S, double> && Valence != std::dynamic_extent)
      for (; ring + 4 <= group.last; ring += 4)
        add_four_rings<reaction, Valence>(memory, group, ring, ring_stiffness, position, force);
    for (; ring < group.last; ++ring) {
      const auto row = static_cast<std::size_t>(ring);
      add_ring<reaction, S, Valence>(static_cast<std::size_t>(memory.rings.vertex[row]),
                                     neighbours_of<Valence>(memory.rings, group, ring),
                                     memory.rest_offset[row], ring_stiffness[row], position, force);
    }
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
