#pragma once

#include "math/scalar.hpp"

namespace trunk {

/// The parameters that a fit may vary, beside the timing of the activation. None is negative.
template <Scalar S>
struct Parameters {
  S elasticity{0.0};      // k_elasticity, N/m, of every shape-memory actuator (paper, "Dynamics")
  S muscle{0.0};          // k_muscle, N/m, of every fibre at A(t) = 1 (paper, "Dynamics")
  S damping{0.0};         // c, N s/m for each particle (our choice: the paper gives none)
  S abdomen_factor{1.0};  // stiffness of the abdominal wall relative to the diaphragm muscle (our choice)
  // These two count only if the model has a pleura.
  S lung_elastance{0.0};  // E_L, Pa/m3
  S resistance{0.0};      // R of the airway and of lung tissue, Pa s/m3
};

/// Returns the parameters in one of the lanes.
template <Scalar S>
Parameters<double> in_lane(const Parameters<S>& p, int lane) noexcept {
  return {in_lane(p.elasticity, lane),     in_lane(p.muscle, lane),         in_lane(p.damping, lane),
          in_lane(p.abdomen_factor, lane), in_lane(p.lung_elastance, lane), in_lane(p.resistance, lane)};
}

}  // namespace trunk
