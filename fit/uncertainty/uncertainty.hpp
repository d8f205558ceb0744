#pragma once

#include <string>
#include <vector>

#include "problem/objective.hpp"
#include "uncertainty/noise.hpp"

namespace trunk {

struct Interval {
  double lower = 0.0, upper = 0.0;
};

/// A parameter with what the data say about it. Intervals are 95 %.
struct Estimate {
  std::string name, unit;
  double value = 0.0;
  double stderr_ = 0.0;  // in the unit; of what is searched for by factors, value * that of its logarithm
  double lower95 = 0.0, upper95 = 0.0;  // residuals correlated as AR(1)
  bool at_bound = false;
  bool identifiable = false;
  Interval naive95{};  // as if every sample were independent
  double prior = 0.0;  // deviation of what was given beforehand, of the logarithm or amount; 0: nothing was
  std::optional<Interval> open_profile{};  // of a profile that is not closed: an end is infinite
};

/// A product of powers of the free parameters, and how well it is determined.
struct Combination {
  std::vector<double> powers;  // [asked for], the largest is 1
  double relative_stderr = 0.0;
};

/// The fit near its best point, as a linear one: what every interval starts from.
struct LocalFit {
  Eigen::VectorXd x;                // coordinates
  Eigen::VectorXd residuals;        // [samples] in deviations
  Eigen::MatrixXd rows;             // d residuals / d x: [samples + what is known beforehand, coordinates]
  Noise noise;                      // in deviations
  Eigen::MatrixXd unit_covariance;  // of x, as if all residuals had deviation 1
  Eigen::MatrixXd covariance;       // of x, AR(1)
  Eigen::MatrixXd naive_covariance;
};

/// None where the model fails beside x.
std::optional<LocalFit> local_fit(Objective& objective, const Eigen::VectorXd& x);

/// Local uncertainty at the best point.
struct Uncertainty {
  std::vector<Estimate> parameters;  // those asked for, in the order of the search space
  std::vector<Estimate> beside;      // those estimated along with them
  Estimate ratio;                    // k_muscle / k_elasticity; empty name where neither is free
  Eigen::MatrixXd log_covariance;    // [asked for, asked for] of logarithms (amounts: of the values), AR(1)
  Eigen::MatrixXd correlation;       // of the same
  std::vector<Combination> combinations;  // best determined first; factors only
  double condition_number = 0.0;  // of the Jacobian in the logarithms, what is estimated beside eliminated
  double residual_autocorrelation = 0.0;  // lag 1
  double noise_autocorrelation = 0.0;     // of the noise that would leave such residuals
  double sigma_m3 = 0.0;                  // deviation of that noise
  double freedom = 0.0;                   // degrees of freedom of the intervals
  bool identifiable = false;
  std::string verdict;
};

/// From the parameters to the verdict on all of them. (parameters, ratio) => identifiable, verdict
void conclude(Uncertainty& uncertainty);

/// A free parameter is called identifiable where its 95 % interval spans less than a factor of 4 (0.4 of its
/// unit, if searched for by amounts), it is not within 2 % of a bound, k_muscle not with k_elasticity at one
/// (our choice), and its profile, if there is one, is closed.
Uncertainty assess(const Objective& objective, const LocalFit& fit);

/// As many numbers fitted as measured: nothing is left to tell how far to trust them.
Uncertainty without_uncertainty(const Objective& objective, const Eigen::VectorXd& x);

/// The 97.5 % point of Student's t.
double t_quantile(double freedom);

}  // namespace trunk
