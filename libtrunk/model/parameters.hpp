#pragma once

#include "math/scalar.hpp"

namespace trunk {

/// The parameters that a fit may vary, beside the timing of the activation. All are positive.
template <Scalar S>
struct Parameters {
  S elasticity{0.0};      // k_elasticity, N/m, of every shape-memory actuator (paper, "Dynamics")
  S muscle{0.0};          // k_muscle, N/m, of every fibre at A(t) = 1 (paper, "Dynamics")
  S damping{0.0};         // c, N s/m for each particle (our choice: the paper gives none)
  S abdomen_factor{1.0};  // stiffness of the abdominal wall relative to the diaphragm muscle (our choice)
};

}  // namespace trunk
