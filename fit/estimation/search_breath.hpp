#pragma once

#include "estimation/estimate.hpp"

namespace trunk {

/// Searches for the best parameters of a breath, and leaves the compartment exact at them. A search that the
/// options name begins at the stiffness of `begin`, any other at the compartment's best point. Both search
/// the same function. (e.algorithm) => e.search, e.cross_check
void search_breath(Objective& trunk, Objective& compartment, CompartmentModel& model,
                   const Parameters<double>& begin, const EstimationOptions& options, Estimation& e);

/// Returns the mechanical parameters asked for: few enough for a search without derivatives.
Indices mechanical_asked_for(const SearchSpace& space);

/// Returns `start` with k_muscle changed until the model's peak volume is the measured one. So a search
/// starts near the valley of good fits, wherever `start` is. Returns `start` unchanged if k_muscle is not
/// free.
Eigen::VectorXd start_at_tidal_volume(Objective& objective, const Eigen::VectorXd& start);

}  // namespace trunk
