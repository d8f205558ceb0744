#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>

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
  Eigen::VectorXd best;  // the best point seen, not the last: NLopt may return either
  double objective = 0.0;
  std::string stop_reason = "not run";
};

/// What to minimise, and where. `value` must be finite everywhere within the bounds: NLopt 2.7.1 takes NaN
/// for success.
struct SearchProblem {
  std::function<double(const Eigen::VectorXd&)> value;
  Eigen::VectorXd lower, upper;
};

/// Runs NLopt from `start`. `cancelled()` is asked before each evaluation and ends the search where it is
/// true. Throws InputError on an unknown algorithm, and whatever `value` throws.
SearchResult minimise(const SearchProblem& problem, const Eigen::VectorXd& start,
                      const SearchOptions& options, const std::function<bool()>& cancelled = {});

}  // namespace trunk
