#pragma once

#include <string>

#include "search/least_squares.hpp"

namespace trunk {

/// The algorithm of a search, and when it stops.
struct SearchOptions {
  std::string algorithm = "bobyqa";    // see algorithm_names
  double coordinate_tolerance = 1e-7;  // stops when every |step| in coordinates <= this
  double objective_tolerance = 1e-12;  // stops when |change| <= this * objective
  int max_evaluations = 600;           // stops when evaluations >= this
  double first_step = 0.25;            // in coordinates: about 25 % of a parameter
  unsigned seed = 1;                   // of random numbers
};

/// The outcome of a search.
struct SearchResult {
  bool converged = false;
  Eigen::VectorXd best;  // the best point seen; NLopt may return the last one instead
  double objective = 0.0;
  std::string stop_reason = "not run";
  int evaluations = 0;
};

/// Returns the names of all algorithms as a message lists them, "bobyqa, sbplx, ... or lm".
std::string algorithm_names();

/// Throws InputError with the known names if there is no algorithm of that name.
void require_algorithm(const std::string& name);

/// Searches from `start` with one of NLopt's algorithms, or with `lm` (see levenberg_marquardt). The global
/// algorithms `mlsl` (multi-level single linkage over a low-discrepancy sequence) and `direct` search the
/// whole box until max_evaluations; then a local search starts from their best point. Throws InputError if
/// the algorithm is unknown, and whatever the problem throws.
SearchResult minimise(const LeastSquares& problem, const Eigen::VectorXd& start,
                      const SearchOptions& options);

/// Searches with GSL's Levenberg-Marquardt algorithm. The Jacobian is that of slopes_at. The change of
/// coordinates x = middle + half width * sin(u) keeps the bounds.
SearchResult levenberg_marquardt(const LeastSquares& problem, const Eigen::VectorXd& start,
                                 const SearchOptions& options);

}  // namespace trunk
