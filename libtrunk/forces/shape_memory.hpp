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

/// neighbours: [valence] positions in ring order, m; the valence may be a compile-time number.
template <Scalar S, class Neighbours>
[[gnu::always_inline]] inline LocalFrame<S> local_frame(const Neighbours& neighbours) noexcept {
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

/// What one ring does: the force F = k (T - P) on its particle, and the terms of what is to be subtracted
/// from the forces on its neighbours. The variational reactions are derived in README, "Design".
template <Scalar S>
struct RingForces {
  Vec3<S> on_particle;
  Vec3<S> share;  // each neighbour's
  Vec3<S> tilt;   // turns the ring's plane; per chord between the neighbours of a neighbour
  Vec3<S> spin;   // turns u: taken up by the first neighbour
};

template <Reaction reaction, Scalar S, class Neighbours>
[[gnu::always_inline]] inline RingForces<S> ring_forces(const Neighbours& neighbours, const Vec3<S>& particle,
                                                        const Vec3<S>& rest_offset,
                                                        const S& stiffness) noexcept {
  const auto frame = local_frame<S>(neighbours);
  const Vec3<S> offset = target_offset(frame, rest_offset);
  const Vec3<S> f = stiffness * (frame.centre + offset - particle);

  const S share(1.0 / static_cast<double>(neighbours.size()));
  if constexpr (reaction == Reaction::published) return {f, share * f, {}, {}};
  const Vec3<S> torque = cross(offset, f);
  const S spin = dot(torque, frame.n);
  const Vec3<S> tilt = cross(torque, frame.n) - (spin * frame.first_height * frame.inverse_radius) * frame.v;
  const Vec3<S> tilt_per_area = frame.inverse_area * (tilt - dot(tilt, frame.n) * frame.n);
  const Vec3<S> spin_force = (spin * frame.inverse_radius) * frame.v;
  return {f, share * (f - spin_force), tilt_per_area, spin_force};
}

/// What is to be subtracted from the force on neighbour j.
template <Reaction reaction, Scalar S, class Neighbours>
[[gnu::always_inline]] inline Vec3<S> reaction_on(std::size_t j, const Neighbours& neighbours,
                                                  const RingForces<S>& ring) noexcept {
  if constexpr (reaction == Reaction::published) return ring.share;
  const std::size_t last = neighbours.size() - 1;
  const Vec3<S> chord = neighbours[j < last ? j + 1 : 0] - neighbours[j > 0 ? j - 1 : last];
  const Vec3<S> shared = ring.share + cross(chord, ring.tilt);
  return j > 0 ? shared : shared + ring.spin;
}

/// The positions of a ring's neighbours, where they are.
template <Scalar S, std::size_t Valence>
struct RingPositions {
  std::span<const int, Valence> ring;
  std::span<const Vec3<S>> position;

  constexpr std::size_t size() const noexcept { return ring.size(); }
  const Vec3<S>& operator[](std::size_t j) const noexcept {
    return position[static_cast<std::size_t>(ring[j])];
  }
};

/// Adds the forces of `count` rings of one valence, from `ring` on: first on the particles, then on the first
/// neighbours, the second ones ..., so that every scalar adds up in the same order. (position, k) => force
template <Reaction reaction, int count, std::size_t Valence, Scalar S>
void add_rings(const ShapeMemory& memory, const RingTable::Group& group, int ring,
               std::span<const S> stiffness, std::span<const Vec3<S>> position,
               std::span<Vec3<S>> force) noexcept {
  RingForces<S> forces[count];
  const auto neighbours = [&](int k) {
    return RingPositions<S, Valence>{neighbours_of<Valence>(memory.rings, group, ring + k), position};
  };
  for (int k = 0; k < count; ++k) {
    const auto row = static_cast<std::size_t>(ring + k),
               vertex = static_cast<std::size_t>(memory.rings.vertex[row]);
    forces[k] = ring_forces<reaction, S>(neighbours(k), position[vertex], lift<S>(memory.rest_offset[row]),
                                         stiffness[row]);
    force[vertex] += forces[k].on_particle;
  }
  for (std::size_t j = 0; j < neighbours(0).size(); ++j)
    for (int k = 0; k < count; ++k)
      force[static_cast<std::size_t>(neighbours(k).ring[j])] -=
          reaction_on<reaction>(j, neighbours(k), forces[k]);
}

/// The same for four rings of a single simulation, side by side in the lanes of a register.
template <Reaction reaction, std::size_t Valence>
void add_four_rings(const ShapeMemory& memory, const RingTable::Group& group, int ring,
                    std::span<const double> stiffness, std::span<const Vec3d> position,
                    std::span<Vec3d> force) noexcept {
  using Four = Lanes<4>;
  const RingTable& rings = memory.rings;
  const auto row = static_cast<std::size_t>(ring);
  const int* neighbour = neighbours_of<Valence>(rings, group, ring).data();
  const auto vertex = [&](std::size_t lane) { return static_cast<std::size_t>(rings.vertex[row + lane]); };
  const auto in_ring = [&](std::size_t lane, std::size_t j) {
    return static_cast<std::size_t>(neighbour[lane * Valence + j]);
  };
  std::array<Vec3<Four>, Valence> neighbours;
  for (std::size_t j = 0; j < Valence; ++j)
    neighbours[j] = packed(position[in_ring(0, j)], position[in_ring(1, j)], position[in_ring(2, j)],
                           position[in_ring(3, j)]);
  const auto& rest = memory.rest_offset;
  const RingForces<Four> forces = ring_forces<reaction, Four>(
      neighbours, packed(position[vertex(0)], position[vertex(1)], position[vertex(2)], position[vertex(3)]),
      packed(rest[row], rest[row + 1], rest[row + 2], rest[row + 3]),
      Four(Four::Register{stiffness[row], stiffness[row + 1], stiffness[row + 2], stiffness[row + 3]}));
  const Unpacked on_vertex = unpacked(forces.on_particle);
  for (std::size_t lane = 0; lane < 4; ++lane) force[vertex(lane)] += on_vertex.lane[lane];
  for (std::size_t j = 0; j < Valence; ++j) {
    const Unpacked on_neighbour = unpacked(reaction_on<reaction>(j, neighbours, forces));
    for (std::size_t lane = 0; lane < 4; ++lane) force[in_ring(lane, j)] -= on_neighbour.lane[lane];
  }
}

/// Adds the forces of all rings. (position, ring_stiffness) => force
template <Reaction reaction, Scalar S>
void add_shape_memory(const ShapeMemory& memory, std::span<const S> ring_stiffness,
                      std::span<const Vec3<S>> position, std::span<Vec3<S>> force) noexcept {
  for_each_valence(memory.rings, [&]<std::size_t Valence>(const RingTable::Group& group) {
    int ring = group.first;
    if constexpr (Valence != std::dynamic_extent)
      for (; ring + 4 <= group.last; ring += 4) {
        if constexpr (std::same_as<S, double>)
          add_four_rings<reaction, Valence>(memory, group, ring, ring_stiffness, position, force);
        else
          add_rings<reaction, 4, Valence>(memory, group, ring, ring_stiffness, position, force);
      }
    for (; ring < group.last; ++ring)
      add_rings<reaction, 1, Valence>(memory, group, ring, ring_stiffness, position, force);
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
