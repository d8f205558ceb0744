#pragma once

#include "uncertainty/uncertainty.hpp"

namespace trunk {

struct Refit {
  Eigen::VectorXd x;
  double objective = 0.0;
  bool at_bound = false;  // a bound kept it from where the data wanted it
};

/// Best fits beside the best one, side by side: Gauss-Newton steps within start + span(directions), with the
/// slopes of the best point throughout (the chord method: no Jacobian is computed anew, and near the best
/// point two steps reach what a search would). `shift` is what to take from the residuals of the curve, for
/// data that differ from those measured; one for all starts or one each; empty: none.
/// directions [coordinates, free].
std::vector<Refit> refits(const LeastSquares& problem, const LocalFit& fit, const Eigen::MatrixXd& directions,
                          const std::vector<Eigen::VectorXd>& starts,
                          const std::vector<Eigen::VectorXd>& shift = {}, int steps = 2);

}  // namespace trunk
