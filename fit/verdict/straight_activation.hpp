#pragma once

#include "estimation/compartment_start.hpp"
#include "verdict/fit_results.hpp"

namespace trunk {

/// Returns what one compartment gives if the activation is made of straight lines, as the paper assumes: its
/// recoil time is free, and the energy of expiration is left out. `fit` is that of a free shape. The trunk is
/// not simulated. `breaths` [breaths][samples] m3 have the measured curve as their mean.
StraightActivation straight_activation(CompartmentFit fit, const Candidate& begin,
                                       const std::vector<std::vector<double>>& breaths);

}  // namespace trunk
