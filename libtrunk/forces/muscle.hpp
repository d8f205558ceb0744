#pragma once

#include "model/model.hpp"

namespace trunk {

/// Adds the pull of every fibre on both ends, equal and opposite: a spring of zero rest length with the
/// stiffness A(t) k_muscle (paper, "Dynamics"). `stiffness` is A(t) k_muscle, N/m. (position) => force
template <Scalar S>
void add_muscle(std::span<const Fibre> fibres, const S& stiffness, std::span<const Vec3<S>> position,
                std::span<Vec3<S>> force) noexcept {
  for (const Fibre& fibre : fibres) {
    const auto insertion = static_cast<std::size_t>(fibre.insertion);
    const auto origin = static_cast<std::size_t>(fibre.origin);
    const Vec3<S> pull = (S(fibre.activity) * stiffness) * (position[origin] - position[insertion]);
    force[insertion] += pull;
    force[origin] -= pull;
  }
}

}  // namespace trunk
