#pragma once

#include "model/model.hpp"

namespace trunk {

/// Sets every force to the weight of its particle, m g (paper, "Force field"). The other field, viscous
/// damping -c v, is taken implicitly by the integrator. () => force
template <Scalar S>
void set_gravity(const Model& model, std::span<Vec3<S>> force) noexcept {
  const Vec3<S> gravity = lift<S>(model.gravity);
  const std::span<const double> mass = model.mass;
  for (std::size_t i = 0; i < mass.size(); ++i) force[i] = S(mass[i]) * gravity;
}

}  // namespace trunk
