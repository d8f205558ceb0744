#pragma once

#include "model/model.hpp"

namespace trunk {

/// Sets every force to the weight of its particle, m g (paper, "Force field"). The integrator treats the
/// other field, viscous damping -c v. () => force
template <Scalar S>
void set_gravity(const Model& model, std::span<Vec3<S>> force) noexcept {
  const Vec3<S> gravity = lift<S>(model.gravity);
  auto on = force.begin();
  for (const double mass : model.mass) *on++ = S(mass) * gravity;
}

}  // namespace trunk
