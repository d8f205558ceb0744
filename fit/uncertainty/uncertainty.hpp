#pragma once

#include <string>
#include <vector>

#include "problem/objective.hpp"

namespace trunk {

/// A parameter with what the data say about it.
struct Estimate {
  std::string name, unit;
  double value = 0.0;
  double stderr_ = 0.0;  // value * standard error of its logarithm
  double lower95 = 0.0, upper95 = 0.0;
  bool at_bound = false;
  bool identifiable = false;
};

/// Local uncertainty at the best point, from the Jacobian of the residuals in log coordinates.
struct Uncertainty {
  std::vector<Estimate> parameters;  // in the order of the search space
  Estimate ratio;                    // k_muscle / k_elasticity; empty name where neither is free
  Eigen::MatrixXd log_covariance;    // [free, free] of the logarithms of the natural values, AR(1)-corrected
  Eigen::MatrixXd correlation;       // [free, free] of the same
  double condition_number = 0.0;     // of the Jacobian in the logarithms of the natural values
  double residual_autocorrelation = 0.0;  // lag 1
  double sigma_m3 = 0.0;                  // residual standard deviation
  bool identifiable = false;
  std::string verdict;
};

/// Covariance of ordinary least squares under residuals that follow AR(1): (J'J)^-1 J' S J (J'J)^-1 with
/// S_ij = s^2 rho^|i-j|. rho = 0 is the textbook s^2 (J'J)^-1.
Eigen::MatrixXd least_squares_covariance(const Eigen::MatrixXd& jacobian, double sigma, double rho);

double lag_one_autocorrelation(const Eigen::VectorXd& residuals);

/// Central differences of the residuals, [samples, free]; one-sided at a bound. Throws std::runtime_error
/// where no neighbour of `x` can be simulated.
Eigen::MatrixXd residual_jacobian(Objective& objective, const Eigen::VectorXd& x);

/// Central differences of the residuals with respect to what was taken from the trace beforehand and is
/// uncertain too: logarithms of rise and falls, the level after the fast fall, the onset (s). [samples, those
/// of the five that are not free]. Throws as residual_jacobian does.
Eigen::MatrixXd timing_jacobian(const Objective& objective, const Eigen::VectorXd& x);

/// Uncertainty at the best point. With `timing_from_trace` the activation's timing counts as estimated
/// together with the parameters, which widens their intervals. A free parameter is called identifiable where
/// its 95 % interval spans less than a factor of 4 and it is not at a bound (our choice).
Uncertainty assess(Objective& objective, const Eigen::VectorXd& x, bool timing_from_trace);

}  // namespace trunk
