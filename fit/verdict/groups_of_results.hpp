#pragma once

#include "verdict/fit_points.hpp"

namespace trunk {

/// Return results of a converged fit with intervals and grades, in the order in which they are shown.

/// The muscle against the recoil, the recoil time, and the stiffnesses that were fitted.
std::vector<FitResult> parameter_results(const FitPoints& points);

/// What a clinic calls these things, and the swings of pressures; nothing where forces do not count.
std::vector<FitResult> clinical_results(const FitPoints& points);

/// Measures of the trunk, and the volume that is left in it; nothing if its breath does not complete.
std::vector<FitResult> measure_results(const FitPoints& points);

}  // namespace trunk
