#include "forces/shape_memory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "errors/input_error.hpp"

namespace trunk {
namespace {

/// Returns the local frame of a ring, with its weighted centre.
LocalFrame<double> frame_of(const ShapeMemory& memory, std::span<const Neighbour> neighbours,
                            std::span<const Vec3d> position) {
  std::vector<Vec3d> points;
  for (const Neighbour n : neighbours) points.push_back(n.in(position));
  LocalFrame<double> frame = local_frame<double>(points);
  if (!memory.extra_weight.empty()) {
    const double* extra = of_ring(memory.extra_weight, memory.rings, neighbours);
    frame.centre += shift_of_mean<double>(points, [&](std::size_t j) { return extra[j]; });
  }
  return frame;
}

/// Takes the rest shape of all rings. (rest) => memory
void take_rest_offsets(std::span<const Vec3d> rest, ShapeMemory& memory) {
  memory.rest_offset.clear();
  for_each_ring(memory.rings, [&](std::size_t, std::size_t vertex, auto neighbours) {
    const LocalFrame<double> frame = frame_of(memory, neighbours, rest);
    const Vec3d offset = rest[vertex] - frame.centre;
    memory.rest_offset.emplace_back(dot(offset, frame.u), dot(offset, frame.v), dot(offset, frame.n));
  });
}

/// Finds the extra weight of each receiving particle in the rings of its neighbours. => memory
void take_received_weights(ShapeMemory& memory) {
  memory.extra_received.clear();
  if (memory.extra_weight.empty()) return;
  std::map<std::pair<int, int>, double> extra;  // of a particle in the ring of another
  for_each_ring(memory.rings, [&](std::size_t, std::size_t vertex, auto neighbours) {
    const double* weight = of_ring(memory.extra_weight, memory.rings, neighbours);
    for (const Neighbour n : neighbours) extra[{n.particle(), static_cast<int>(vertex)}] = *weight++;
  });
  for_each_ring(memory.receiving, [&](std::size_t, std::size_t vertex, auto neighbours) {
    for (const Neighbour n : neighbours)
      memory.extra_received.push_back(extra.at({static_cast<int>(vertex), n.particle()}));
  });
}

void require_usable(const Surface& surface) {
  for (const auto& [vertex, neighbours] : surface.one_rings())
    if (neighbours.size() < 3 || neighbours.size() > max_valence)
      throw InputError({},
                       fmt::format("surface '{}': particle {} has {} neighbours", surface.name(), vertex,
                                   neighbours.size()),
                       fmt::format("3 to {}", max_valence));
}

/// Rotates each ring so that it begins with the neighbour most upward of the particle, or of several the one
/// most forward. A left-right mirror image has the same beginnings, so that a symmetric body stays symmetric.
void begin_upward(RingTable& rings, std::span<const Vec3d> rest) {
  const double tie = 1e-9;
  for (const RingTable::Group& group : rings.groups)
    for (int r = group.first; r < group.last; ++r) {
      const Vec3d& particle = rest[static_cast<std::size_t>(rings.vertex[static_cast<std::size_t>(r)])];
      const auto begin = rings.neighbour.begin() + group.first_neighbour +
                         static_cast<std::ptrdiff_t>(r - group.first) * group.valence;
      const auto toward = [&](Neighbour n) {
        const Vec3d d = n.in(rest)-particle;
        return (1.0 / norm(d)) * d;
      };
      const auto first = std::max_element(begin, begin + group.valence, [&](Neighbour i, Neighbour j) {
        const Vec3d a = toward(i), b = toward(j);
        return std::abs(a.z() - b.z()) > tie ? a.z() < b.z() : a.y() + tie < b.y();
      });
      std::rotate(begin, first, begin + group.valence);
    }
}

}  // namespace

Vec3d target_of(const ShapeMemory& memory, std::size_t ring, std::span<const Neighbour> neighbours,
                std::span<const Vec3d> position) {
  const LocalFrame<double> frame = frame_of(memory, neighbours, position);
  return frame.centre + target_offset(frame, memory.rest_offset[ring]);
}

double shape_memory_energy(const ShapeMemory& memory, std::span<const double> ring_stiffness,
                           std::span<const Vec3d> position) {
  double energy = 0.0;
  for_each_ring(memory.rings, [&](std::size_t ring, std::size_t vertex, auto neighbours) {
    const Vec3d stretch = target_of(memory, ring, neighbours, position) - position[vertex];
    energy += 0.5 * ring_stiffness[ring] * dot(stretch, stretch);
  });
  return energy;
}

ShapeMemory make_shape_memory(const Surface& surface, std::span<const Vec3d> rest,
                              std::span<const double> stiffness_weight,
                              std::span<const double> abdominal_share, Reaction reaction) {
  require_usable(surface);
  ShapeMemory memory;
  memory.reaction = reaction;
  memory.rings = ring_table(surface);
  begin_upward(memory.rings, rest);
  memory.receiving = memory.rings;
  take_rest_offsets(rest, memory);
  for (const int vertex : memory.rings.vertex) {
    memory.stiffness_weight.push_back(stiffness_weight[static_cast<std::size_t>(vertex)]);
    memory.abdominal_share.push_back(abdominal_share[static_cast<std::size_t>(vertex)]);
  }
  return memory;
}

void weigh_neighbours(std::span<const double> weights, std::span<const Vec3d> rest, ShapeMemory& memory) {
  memory.extra_weight.assign(weights.begin(), weights.end());
  auto extra = memory.extra_weight.begin();
  for_each_ring(memory.rings, [&](std::size_t, std::size_t, auto neighbours) {
    for (std::size_t j = 0; j < neighbours.size(); ++j)
      *extra++ -= 1.0 / static_cast<double>(neighbours.size());
  });
  take_received_weights(memory);
  take_rest_offsets(rest, memory);
}

void leave_out_unpushed(const std::vector<bool>& pushed, ShapeMemory& memory) {
  ShapeMemory acting;
  acting.reaction = memory.reaction;
  acting.rings = only_those(
      memory.rings, [&](int vertex, auto neighbours) { return any_of_ring(pushed, vertex, neighbours); });
  acting.receiving =
      only_those(memory.rings, [&](int vertex, auto) { return pushed[static_cast<std::size_t>(vertex)]; });
  for_each_ring(memory.rings, [&](std::size_t row, std::size_t vertex, auto neighbours) {
    if (!any_of_ring(pushed, static_cast<int>(vertex), neighbours)) return;
    acting.rest_offset.push_back(memory.rest_offset[row]);
    acting.stiffness_weight.push_back(memory.stiffness_weight[row]);
    acting.abdominal_share.push_back(memory.abdominal_share[row]);
    if (memory.extra_weight.empty()) return;
    const double* extra = of_ring(memory.extra_weight, memory.rings, neighbours);
    acting.extra_weight.insert(acting.extra_weight.end(), extra, extra + neighbours.size());
  });
  take_received_weights(acting);
  memory = std::move(acting);
}

}  // namespace trunk
