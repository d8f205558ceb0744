#pragma once

#include "model/model.hpp"

namespace trunk {

/// Adds the focal forces at `time_s` (paper, "Focal force"). () => force
template <Scalar S>
void add_focal(std::span<const FocalForce> forces, double time_s, std::span<Vec3<S>> force) noexcept {
  for (const FocalForce& f : forces)
    force[static_cast<std::size_t>(f.particle)] += S(f.magnitude(time_s)) * lift<S>(f.direction);
}

}  // namespace trunk
