#pragma once

#include <functional>
#include <string>

#include "problem/objective.hpp"

namespace trunk {

/// When a search stops, each an inequality.
struct SearchOptions {
  std::string algorithm = "bobyqa";    // bobyqa | sbplx | cobyla | neldermead
  double coordinate_tolerance = 1e-7;  // stops when every |step| in log coordinates <= this
  double objective_tolerance = 1e-12;  // stops when |change| <= this * objective
  int max_evaluations = 600;           // stops when evaluations >= this
  double first_step = 0.25;            // in log coordinates: about 25 %
};

struct SearchResult {
  bool converged = false;
  Eigen::VectorXd best;   // coordinates of the best evaluation seen, not of the last
  double objective = 0.0;
  std::string stop_reason = "not run";
};

/// Runs NLopt from `start` within the bounds of the objective's space. `cancelled()` is asked before each
/// evaluation and ends the search where it is true. Throws InputError on an unknown algorithm, and whatever the
/// objective throws.
SearchResult minimise(Objective& objective, const Eigen::VectorXd& start, const SearchOptions& options,
                      const std::function<bool()>& cancelled = {});

/// Moves the coordinate of k_muscle until the model's peak volume is the measured one, by secants: a start near
/// the valley from anywhere. Returns `start` where k_muscle is not free or no step helps.
Eigen::VectorXd start_at_tidal_volume(Objective& objective, const Eigen::VectorXd& start);

}  // namespace trunk
