#pragma once

#include "model/model.hpp"

namespace trunk {

/// Adds the forces of the springs between neighbours, equal and opposite. They resist stretch within a flat
/// patch, which shape memory does not (our choice, an option). (position) => force
template <Scalar S>
void add_membrane(std::span<const MembraneEdge> edges, std::span<const Vec3<S>> position,
                  std::span<Vec3<S>> force) noexcept {
  using std::sqrt;
  for (const MembraneEdge& edge : edges) {
    const auto a = static_cast<std::size_t>(edge.a), b = static_cast<std::size_t>(edge.b);
    const Vec3<S> along = position[b] - position[a];
    const S length = sqrt(dot(along, along));
    const Vec3<S> pull = (S(edge.stiffness) * (S(1.0) - S(edge.rest_length) / length)) * along;
    force[a] += pull;
    force[b] -= pull;
  }
}

}  // namespace trunk
