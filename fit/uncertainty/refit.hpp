#pragma once

#include "uncertainty/uncertainty.hpp"

namespace trunk {

/// A fit from a start near the best point.
struct Refit {
  Eigen::VectorXd x;
  double objective = 0.0;
  bool at_bound = false;  // a bound stopped its last step
};

/// Returns the best fits within start + span(directions), computed side by side by Gauss-Newton steps. All
/// steps use the slopes of the best point (chord method), so no new Jacobian is needed; near the best point
/// two steps get as far as a search. `shift` [starts] is subtracted from the residuals of the curve, for data
/// that differ from the measured data; empty: nothing is subtracted. directions [coordinates, free].
std::vector<Refit> refits(const LeastSquares& problem, const LocalFit& fit, const Eigen::MatrixXd& directions,
                          const std::vector<Eigen::VectorXd>& starts,
                          const std::vector<Eigen::VectorXd>& shift = {}, int steps = 2);

}  // namespace trunk
