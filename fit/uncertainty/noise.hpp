#pragma once

#include <Eigen/Core>
#include <vector>

namespace trunk {

/// The noise estimated from residuals. It follows AR(1): the correlation of samples i and j is rho^|i-j|.
struct Noise {
  double rho = 0.0;              // of the noise, not of the residuals
  double deviation = 0.0;        // of the noise, with this rho
  double white_deviation = 0.0;  // as in textbooks: as if samples were independent
  double freedom = 0.0;          // samples less fitted parameters
};

/// Returns the autocorrelation of residuals about 0 at `lag` samples.
double autocorrelation(const Eigen::VectorXd& residuals, Eigen::Index lag);

/// Returns the noise that leaves `residuals` [n] after a fit with `jacobian` [n, p].
///
/// A fit removes part of the noise, and the residuals look less correlated than the noise was. So rho and the
/// deviation come from the restricted likelihood (REML, Patterson and Thompson 1971), which uses only what no
/// parameter could have fitted. They are the means of log(1 - rho) and of the log deviation under that
/// likelihood, between rho = 0 and 0.999. We take means because a short series hardly bounds rho from above.
/// With the most likely rho, 95 % intervals covered the truth in 89 to 93 % of repeats (100 to 200 samples,
/// rho = 0.9, 2 or 7 parameters); with the means they covered it in 95 to 97 %.
Noise estimate_noise(const Eigen::VectorXd& residuals, const Eigen::MatrixXd& jacobian);

/// Returns the correlation of neighbouring samples in the noise of breaths [breaths][samples], 0 to 0.98:
/// that of what is left of each breath once the multiple of the mean that fits it best is taken off. It is 0
/// for fewer than three breaths, which show no noise.
double noise_correlation(const Eigen::VectorXd& mean, const std::vector<std::vector<double>>& breaths);

/// Returns the Bayesian information criterion of a model with these residuals and AR(1) noise: -2 log L at
/// the best rho and deviation, plus log n for each parameter and for those two. A change of the unit adds the
/// same constant to all models of the same data.
double ar1_bic(const Eigen::VectorXd& residuals, std::size_t parameters);

/// Returns the covariance of n samples, deviation^2 rho^|i-j|, [n, n].
Eigen::MatrixXd noise_covariance(Eigen::Index n, double deviation, double rho);

/// Returns the covariance of a least-squares estimate with the Jacobian `rows` = [data rows; prior rows]. The
/// data rows have noise of covariance `noise`, the prior rows noise of deviation 1. It is A+ diag(noise, 1)
/// A+' with the pseudo-inverse A+. Without priors and with noise = s^2 it is the textbook's s^2 (J'J)^-1.
Eigen::MatrixXd least_squares_covariance(const Eigen::MatrixXd& rows, const Eigen::MatrixXd& noise);

}  // namespace trunk
