#pragma once

#include <Eigen/Core>

namespace trunk {

/// What residuals say of the noise, taken to follow AR(1): correlation rho^|i-j| between samples i and j.
struct Noise {
  double rho = 0.0;              // of the noise, not of the residuals
  double deviation = 0.0;        // of the noise under rho
  double white_deviation = 0.0;  // the textbook one: samples taken as independent
  double freedom = 0.0;          // samples less what was fitted
};

/// Of residuals about 0, `lag` samples apart.
double autocorrelation(const Eigen::VectorXd& residuals, Eigen::Index lag);

/// Fitting takes some of the noise away and makes what is left look less correlated than it was, the more the
/// smoother the fitted directions are. Therefore rho and the deviation come from the restricted likelihood
/// (REML, Patterson and Thompson 1971), which sees only what no parameter could have fitted: the means of
/// log(1 - rho) and log deviation over it, between rho = 0 and 0.999. Means, because a series of a few
/// correlation lengths hardly bounds rho from above: with the most likely rho, 95 % intervals covered the
/// truth in 89 to 93 % of repeats (100 to 200 samples, rho = 0.9, 2 or 7 parameters), with the means in 95 to
/// 97. residuals [n], jacobian [n, p].
Noise estimate_noise(const Eigen::VectorXd& residuals, const Eigen::MatrixXd& jacobian);

/// Bayesian information criterion of a model that leaves these residuals (unit free up to a constant shared
/// by models of the same data), with AR(1) noise: -2 log L at the best rho and deviation, plus log n for each
/// of the parameters and those two.
double ar1_bic(const Eigen::VectorXd& residuals, std::size_t parameters);

/// Covariance of n samples: deviation^2 rho^|i-j|, [n, n].
Eigen::MatrixXd noise_covariance(Eigen::Index n, double deviation, double rho);

/// Covariance of the estimate by least squares over `rows` = [data rows; prior rows] whose noise has the
/// covariance `noise` in the data rows and deviation 1 in the others: A+ diag(noise, 1) A+', A+ the pseudo
/// inverse. Without priors and with noise = s^2 it is the textbook s^2 (J'J)^-1.
Eigen::MatrixXd least_squares_covariance(const Eigen::MatrixXd& rows, const Eigen::MatrixXd& noise);

}  // namespace trunk
