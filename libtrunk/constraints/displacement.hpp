#pragma once

#include "model/model.hpp"

namespace trunk {

/// Puts the particles with an imposed displacement in their place at `time_s`, on the imposed axes only
/// (paper, "Boundary conditions"). => position
template <Scalar S>
void impose_displacements(const Model& model, double time_s, std::span<Vec3<S>> position) noexcept {
  for (const ImposedDisplacement& d : model.imposed_displacements) {
    const auto i = static_cast<std::size_t>(d.particle);
    const Vec3<S> imposed = lift<S>(model.rest[i] + d.magnitude(time_s) * d.direction);
    position[i] += scaled(d.axes, imposed - position[i]);
  }
}

}  // namespace trunk
