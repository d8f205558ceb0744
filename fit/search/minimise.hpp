#pragma once

#include <string>

#include "search/least_squares.hpp"

namespace trunk {

/// How a search goes, and when it stops: each an inequality.
struct SearchOptions {
  std::string algorithm = "bobyqa";    // see algorithm_names
  double coordinate_tolerance = 1e-7;  // stops when every |step| in coordinates <= this
  double objective_tolerance = 1e-12;  // stops when |change| <= this * objective
  int max_evaluations = 600;           // stops when evaluations >= this
  double first_step = 0.25;            // in coordinates: about 25 % of a parameter
  unsigned seed = 1;                   // of what is random in it
};

struct SearchResult {
  bool converged = false;
  Eigen::VectorXd best;  // the best point seen, not the last: NLopt may return either
  double objective = 0.0;
  std::string stop_reason = "not run";
  int evaluations = 0;
};

/// "bobyqa, sbplx, ...": derivative-free, with a gradient by differences, global, and GSL's.
std::string algorithm_names();

/// Throws InputError, listing the names there are.
void require_algorithm(const std::string& name);

/// Searches from `start` with the algorithm of that name: NLopt's, or `lm` (see levenberg_marquardt). The
/// global ones, `mlsl` (multi-level single linkage over a low-discrepancy sequence) and `direct`, look at the
/// whole box until max_evaluations and are followed by a local search from their best point. Throws
/// InputError on an unknown algorithm, and whatever the problem throws.
SearchResult minimise(const LeastSquares& problem, const Eigen::VectorXd& start,
                      const SearchOptions& options);

/// GSL's Levenberg-Marquardt, the Jacobian by forward differences. Bounds are kept by x = middle + half width
/// * sin(u).
SearchResult levenberg_marquardt(const LeastSquares& problem, const Eigen::VectorXd& start,
                                 const SearchOptions& options);

}  // namespace trunk
