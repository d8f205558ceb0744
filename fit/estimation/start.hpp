#pragma once

#include "breaths/mean_breath.hpp"
#include "problem/objective.hpp"
#include "scenarios/read_scenario.hpp"

namespace trunk {

/// The measured a measured breath makes. `weighted`: by the breath's own deviation of each sample.
MeasuredCurve measured_curve_of(const MeasuredBreath& breath, bool weighted = false);

/// Times the scenario's activation after a measured breath (our choice; the paper's 2 s, 0.5 s, 2 s are one
/// subject's). The volume lags behind the muscle, so its own peak and fall are only the start: rise and falls
/// are those with which a one-compartment model follows the breath best.
void adopt_timing(const MeasuredBreath& breath, Scenario& scenario);

/// Moves the coordinate of k_muscle until the model's peak volume is the measured one: a start near the
/// valley from anywhere. Returns `start` where k_muscle is not free.
Eigen::VectorXd start_at_tidal_volume(Objective& objective, const Eigen::VectorXd& start);

}  // namespace trunk
