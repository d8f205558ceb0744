#pragma once

#include "problem/objective.hpp"

namespace trunk {

/// Moves the coordinate of k_muscle until the model's peak volume is the measured one: a start near the
/// valley from anywhere. Returns `start` where k_muscle is not free.
Eigen::VectorXd start_at_tidal_volume(Objective& objective, const Eigen::VectorXd& start);

}  // namespace trunk
