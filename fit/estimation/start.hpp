#pragma once

#include "breaths/mean_breath.hpp"
#include "problem/objective.hpp"
#include "scenarios/read_scenario.hpp"

namespace trunk {

/// Returns the curve of a measured breath. With `weighted`, each sample has the deviation that the breath
/// gives.
MeasuredCurve measured_curve_of(const MeasuredBreath& breath, bool weighted = false);

/// Sets the timing of the scenario's activation from a measured breath (our choice; the paper's 2 s, 0.5 s
/// and 2 s belong to one subject). The volume lags behind the muscle, so its peak and fall are only a first
/// guess: the rise and falls are those with which a one-compartment model follows the breath best.
void adopt_timing(const MeasuredBreath& breath, Scenario& scenario);

/// Returns `start` with k_muscle changed until the model's peak volume is the measured one. So a search
/// starts near the valley of good fits, wherever `start` is. Returns `start` unchanged if k_muscle is not
/// free.
Eigen::VectorXd start_at_tidal_volume(Objective& objective, const Eigen::VectorXd& start);

}  // namespace trunk
