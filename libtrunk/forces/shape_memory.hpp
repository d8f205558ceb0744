#pragma once

#include <array>

#include "math/lanes.hpp"
#include "mesh/volume.hpp"
#include "model/model.hpp"
#include "model/workspace.hpp"

namespace trunk {

/// The most neighbours that a particle may have: more than in any sensible mesh, so more are a mistake of the
/// mesh.
inline constexpr std::size_t max_valence = 64;

/// The local frame of a one-ring: the centre G of the neighbours, the unit normal n along their area vector,
/// u toward the first neighbour within the surface, and v = n x u (paper, figure "local coordinate system"; u
/// is our choice). The frame does not depend on the particle itself.
template <Scalar S>
struct LocalFrame {
  Vec3<S> centre, u, v, n;
  Vec3<S> area;      // twice the area vector, m2
  S inverse_area;    // 1 / |area|, 1/m2
  S first_height;    // n . (N_1 - G), m
  S inverse_radius;  // 1 / distance of N_1 from the axis through G along n, 1/m
};

/// Returns the local frame of a ring. neighbours: [valence] positions in ring order, m; the valence may be
/// known at compile time. The two roots and the two divisions do not wait for each other.
template <Scalar S, class Neighbours>
[[gnu::always_inline]] inline LocalFrame<S> local_frame(const Neighbours& neighbours) noexcept {
  using std::sqrt;
  const std::size_t m = neighbours.size();
  const auto [sum, area] = sum_and_twice_area<S>(neighbours);
  LocalFrame<S> frame;
  frame.area = area;
  frame.centre = S(1.0 / static_cast<double>(m)) * sum;
  const Vec3<S> to_first = neighbours[0] - frame.centre;
  const Vec3<S> sideways = cross(area, to_first);
  const S squared_area = dot(area, area);
  const S inverse_sideways = S(1.0) / sqrt(dot(sideways, sideways));
  frame.inverse_area = S(1.0) / sqrt(squared_area);
  frame.n = frame.inverse_area * area;
  frame.v = inverse_sideways * sideways;
  frame.u = cross(frame.v, frame.n);
  frame.first_height = dot(frame.n, to_first);
  frame.inverse_radius = frame.inverse_area * squared_area * inverse_sideways;
  return frame;
}

/// Returns how far the extra weights of the neighbours move their mean, m. extra: (j), they sum to 0
template <Scalar S, class Neighbours, class Extra>
[[gnu::always_inline]] inline Vec3<S> shift_of_mean(const Neighbours& neighbours,
                                                    const Extra& extra) noexcept {
  Vec3<S> shift = extra(0) * neighbours[0];
  for (std::size_t j = 1; j < neighbours.size(); ++j) shift += extra(j) * neighbours[j];
  return shift;
}

/// Returns where the particle would be at rest relative to its neighbours, T - G = x0 u + y0 v + z0 n (paper,
/// "Dynamics"). The paper has two angles and a distance; Cartesian numbers are also defined at a distance of
/// zero.
template <Scalar S>
Vec3<S> target_offset(const LocalFrame<S>& frame, const Vec3<S>& rest_offset) noexcept {
  return rest_offset.x() * frame.u + rest_offset.y() * frame.v + rest_offset.z() * frame.n;
}

/// The forces of one ring: F = k (T - P) on its particle, and the terms of the reactions, which are
/// subtracted from the forces on its neighbours. libtrunk/README.md ("Reaction") derives the variational
/// reactions.
template <Scalar S>
struct RingForces {
  Vec3<S> on_particle;
  Vec3<S> share;  // on each neighbour
  Vec3<S> tilt;   // turns the ring's plane; per chord between the neighbours of a neighbour
  Vec3<S> spin;   // turns u; acts on the first neighbour
  Vec3<S> area;   // twice the ring's area vector, m2
};

template <Reaction reaction, Scalar S>
[[gnu::always_inline]] inline RingForces<S> ring_forces(const LocalFrame<S>& frame, std::size_t valence,
                                                        const Vec3<S>& particle, const Vec3<S>& rest_offset,
                                                        const S& stiffness) noexcept {
  const Vec3<S> place = particle - frame.centre;
  // In the local frame: the force, and the torque of the rest offset.
  const S fu = stiffness * (rest_offset.x() - dot(place, frame.u)),
          fv = stiffness * (rest_offset.y() - dot(place, frame.v)),
          fn = stiffness * (rest_offset.z() - dot(place, frame.n));
  const Vec3<S> f = fu * frame.u + fv * frame.v + fn * frame.n;
  const S share(1.0 / static_cast<double>(valence));
  if constexpr (reaction == Reaction::published) return {f, share * f, {}, {}, frame.area};
  const S torque_u = rest_offset.y() * fn - rest_offset.z() * fv,
          torque_v = rest_offset.z() * fu - rest_offset.x() * fn,
          spin = (rest_offset.x() * fv - rest_offset.y() * fu) * frame.inverse_radius;
  const S tilt_u = frame.inverse_area * torque_v,
          tilt_v = frame.inverse_area * (torque_u + spin * frame.first_height);
  const Vec3<S> spin_force = spin * frame.v;
  return {f, share * (f - spin_force), tilt_u * frame.u - tilt_v * frame.v, spin_force, frame.area};
}

/// Calculates the forces of one ring. (position) => reactions
template <Reaction reaction, bool weighted, std::size_t Valence, Scalar S>
void calc_ring(const ShapeMemory& memory, const RingTable::Group& group, int ring,
               std::span<const S> stiffness, std::span<const Vec3<S>> position,
               RingReactions<S>& reactions) noexcept {
  const auto row = static_cast<std::size_t>(ring), i = static_cast<std::size_t>(memory.rings.vertex[row]);
  const RingPositions<S, Valence> neighbours{neighbours_of<Valence>(memory.rings, group, ring), position};
  LocalFrame<S> frame = local_frame<S>(neighbours);
  if constexpr (weighted) {
    const double* extra = of_ring(memory.extra_weight, memory.rings, neighbours.ring);
    frame.centre += shift_of_mean<S>(neighbours, [&](std::size_t j) { return S(extra[j]); });
  }
  const auto found = ring_forces<reaction, S>(frame, neighbours.size(), position[i],
                                              lift<S>(memory.rest_offset[row]), stiffness[row]);
  reactions.on_particle[i] = found.on_particle;
  reactions.share[i] = found.share;
  reactions.tilt[i] = found.tilt;
  reactions.spin[i] = found.spin;
  reactions.area[i] = found.area;
}

#ifdef __AVX__
/// Four rings side by side. Each neighbour is packed where it is needed, since the registers do not hold all
/// of them.
template <std::size_t Valence, class InRing>
struct PackedRing {
  const InRing& in_ring;  // (lane, j)

  static constexpr std::size_t size() noexcept { return Valence; }
  [[gnu::always_inline]] Vec3<Lanes<4>> operator[](std::size_t j) const noexcept {
    return packed(in_ring(0, j), in_ring(1, j), in_ring(2, j), in_ring(3, j));
  }
};

/// Calculates the forces of four rings of one simulation, side by side in the lanes of a register.
/// (position) => reactions
template <Reaction reaction, bool weighted, std::size_t Valence>
void calc_four_rings(const ShapeMemory& memory, const RingTable::Group& group, int ring,
                     std::span<const double> stiffness, std::span<const Vec3d> position,
                     RingReactions<double>& reactions) noexcept {
  using Four = Lanes<4>;
  const auto row = static_cast<std::size_t>(ring);
  const std::span<const Neighbour, Valence> first = neighbours_of<Valence>(memory.rings, group, ring);
  const Neighbour* neighbour = first.data();
  const auto vertex = [&](std::size_t lane) {
    return static_cast<std::size_t>(memory.rings.vertex[row + lane]);
  };
  const auto in_ring = [&](std::size_t lane, std::size_t j) -> const Vec3d& {
    return neighbour[lane * Valence + j].in(position);
  };
  const PackedRing<Valence, decltype(in_ring)> neighbours{in_ring};
  const auto& rest = memory.rest_offset;
  // The frame comes before the rest is packed, since registers are few.
  LocalFrame<Four> frame = local_frame<Four>(neighbours);
  if constexpr (weighted) {
    const double* extra = of_ring(memory.extra_weight, memory.rings, first);
    frame.centre += shift_of_mean<Four>(neighbours, [&](std::size_t j) {
      return Four(
          Four::Register{extra[j], extra[Valence + j], extra[2 * Valence + j], extra[3 * Valence + j]});
    });
  }
  const RingForces<Four> found = ring_forces<reaction, Four>(
      frame, Valence,
      packed(position[vertex(0)], position[vertex(1)], position[vertex(2)], position[vertex(3)]),
      packed(rest[row], rest[row + 1], rest[row + 2], rest[row + 3]),
      Four(Four::Register{stiffness[row], stiffness[row + 1], stiffness[row + 2], stiffness[row + 3]}));
  const Unpacked on_particle = unpacked(found.on_particle), share = unpacked(found.share),
                 tilt = unpacked(found.tilt), spin = unpacked(found.spin), area = unpacked(found.area);
  for (std::size_t lane = 0; lane < 4; ++lane) {
    const std::size_t i = vertex(lane);
    reactions.on_particle[i] = on_particle.lane[lane];
    reactions.share[i] = share.lane[lane];
    reactions.tilt[i] = tilt.lane[lane];
    reactions.spin[i] = spin.lane[lane];
    reactions.area[i] = area.lane[lane];
  }
}
#endif

/// Calculates the forces of all rings of one valence, four at a time where possible. The last four may
/// include rings that are done already; their results are the same. (position) => reactions
template <Reaction reaction, bool weighted, std::size_t Valence, Scalar S>
void calc_rings(const ShapeMemory& memory, const RingTable::Group& group, std::span<const S> stiffness,
                std::span<const Vec3<S>> position, RingReactions<S>& reactions) noexcept {
#ifdef __AVX__
  if constexpr (std::same_as<S, double> && Valence != std::dynamic_extent)
    if (group.last - group.first >= 4) {
      for (int ring = group.first; ring < group.last; ring += 4)
        calc_four_rings<reaction, weighted, Valence>(memory, group, std::min(ring, group.last - 4), stiffness,
                                                     position, reactions);
      return;
    }
#endif
  for (int ring = group.first; ring < group.last; ++ring)
    calc_ring<reaction, weighted, Valence, S>(memory, group, ring, stiffness, position, reactions);
}

/// Adds up the forces of the rings on each particle. On a closed surface, the rings that react on a particle
/// are those of its own neighbours, and in the ring of neighbour j it stands between j + 1 and j - 1. The sum
/// of (N_(j-1) - N_(j+1)) x tilt_j is thus how twice the area of its own ring grows with the tilts. A
/// neighbour with an extra weight takes that share of the force more. (position, reactions) => force
template <Reaction reaction, bool weighted, Scalar S>
void add_ring_forces(const ShapeMemory& memory, std::span<const Vec3<S>> position,
                     const RingReactions<S>& reactions, std::span<Vec3<S>> force) noexcept {
  for_each_ring(memory.receiving, [&]<std::size_t Valence>(std::size_t, std::size_t vertex,
                                                           std::span<const Neighbour, Valence> ring) {
    const RingPositions<S, Valence> share{ring, reactions.share};
    Vec3<S> asked = share[0];
    for (std::size_t j = 1; j < ring.size(); ++j) asked += share[j];
    if constexpr (weighted) {
      const double* extra = of_ring(memory.extra_received, memory.receiving, ring);
      asked += shift_of_mean<S>(RingPositions<S, Valence>{ring, reactions.on_particle},
                                [&](std::size_t j) { return S(extra[j]); });
    }
    if constexpr (reaction == Reaction::variational)
      asked += twice_area_change<S>(RingPositions<S, Valence>{ring, position},
                                    RingPositions<S, Valence>{ring, reactions.tilt});
    force[vertex] += reactions.on_particle[vertex] - asked;
  });
  if constexpr (reaction == Reaction::variational)
    for_each_ring(memory.rings, [&](std::size_t, std::size_t vertex, auto ring) {
      ring[0].in(force) -= reactions.spin[vertex];
    });
}

/// Adds the forces of all rings. The rings come first and the sums for the particles second, so that no ring
/// waits for another. Particles that no force moves get only parts of their forces.
/// (position, ring_stiffness) => reactions, force
template <Reaction reaction, Scalar S, bool weighted = false>
void add_shape_memory(const ShapeMemory& memory, std::span<const S> ring_stiffness,
                      std::span<const Vec3<S>> position, RingReactions<S>& reactions,
                      std::span<Vec3<S>> force) noexcept {
  for_each_valence(memory.rings, [&]<std::size_t Valence>(const RingTable::Group& group) {
    calc_rings<reaction, weighted, Valence, S>(memory, group, ring_stiffness, position, reactions);
  });
  add_ring_forces<reaction, weighted, S>(memory, position, reactions, force);
}

template <Scalar S>
void add_shape_memory(const ShapeMemory& memory, std::span<const S> ring_stiffness,
                      std::span<const Vec3<S>> position, RingReactions<S>& reactions,
                      std::span<Vec3<S>> force) noexcept {
  if (memory.reaction == Reaction::published)
    add_shape_memory<Reaction::published, S>(memory, ring_stiffness, position, reactions, force);
  else if (memory.extra_weight.empty())
    add_shape_memory<Reaction::variational, S>(memory, ring_stiffness, position, reactions, force);
  else
    add_shape_memory<Reaction::variational, S, true>(memory, ring_stiffness, position, reactions, force);
}

/// Returns the energy 1/2 k |P - T|^2 summed over the rings, J. The variational forces are its negative
/// gradient.
double shape_memory_energy(const ShapeMemory& memory, std::span<const double> ring_stiffness,
                           std::span<const Vec3d> position);

/// Returns the shape memory of a closed surface at rest; throws InputError if a ring has fewer than 3 or more
/// than max_valence neighbours. rest: [particles] m; stiffness_weight, abdominal_share: [particles].
ShapeMemory make_shape_memory(const Surface& surface, std::span<const Vec3d> rest,
                              std::span<const double> stiffness_weight,
                              std::span<const double> abdominal_share, Reaction reaction);

/// Gives the neighbours of each ring these weights in its centre, and takes the rest shape again. weights:
/// [as memory.rings.neighbour], those of a ring sum to 1; rest: [particles] m. => memory
void weigh_neighbours(std::span<const double> weights, std::span<const Vec3d> rest, ShapeMemory& memory);

/// Returns the place T to which a ring draws its particle, m. ring: the row in memory.rings, and its
/// neighbours
Vec3d target_of(const ShapeMemory& memory, std::size_t ring, std::span<const Neighbour> neighbours,
                std::span<const Vec3d> position);

/// Removes the forces on particles that no force moves, and the rings that act only on such particles.
/// pushed: [particles]. => memory
void leave_out_unpushed(const std::vector<bool>& pushed, ShapeMemory& memory);

}  // namespace trunk
