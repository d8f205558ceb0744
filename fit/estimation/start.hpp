#pragma once

#include "breaths/mean_breath.hpp"
#include "problem/measured_curve.hpp"
#include "scenarios/read_scenario.hpp"

namespace trunk {

/// Returns the curve of a measured breath. With `weighted`, each sample has the deviation that the breath
/// gives.
MeasuredCurve measured_curve_of(const MeasuredBreath& breath, bool weighted = false);

/// Returns a first guess of the activation: straight lines that rise over the inspiration and fall over the
/// expiration (our choice). The volume lags behind the muscle, so it is only where searches begin.
BreathActivation<double> activation_from_landmarks(const MeasuredBreath& breath);

}  // namespace trunk
