#pragma once

#include "model/model.hpp"

namespace trunk {

/// Sets every force to the weight of its particle, m g (paper, "Force field"). The other field, viscous
/// damping -c v, is taken implicitly by the integrator. () => force
template <Scalar S>
void set_gravity(const Model& model, std::span<Vec3<S>> force) noexcept {
  for (std::size_t i = 0; i < model.particles(); ++i) force[i] = S(model.mass[i]) * lift<S>(model.gravity);
}

}  // namespace trunk
