#pragma once

#include "model/model.hpp"

namespace trunk {

/// Adds the pressures at `time_s` (LML `Pressure`). The force on a triangle is the pressure times its area,
/// against the side that it faces, a third at each corner. It follows the surface (our choice).
/// (position) => force
template <Scalar S>
void add_pressure(std::span<const PressureLoad> loads, double time_s, std::span<const Vec3<S>> position,
                  std::span<Vec3<S>> force) noexcept {
  for (const PressureLoad& load : loads) {
    const S third(load.magnitude(time_s) / 6.0);
    for (const Triangle& t : load.triangles) {
      const auto at = [&](std::size_t corner) { return static_cast<std::size_t>(t[corner]); };
      const Vec3<S> twice_area = cross(position[at(1)] - position[at(0)], position[at(2)] - position[at(0)]);
      for (std::size_t corner = 0; corner < 3; ++corner) force[at(corner)] -= third * twice_area;
    }
  }
}

}  // namespace trunk
