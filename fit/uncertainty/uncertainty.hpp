#pragma once

#include <string>
#include <vector>

#include "problem/objective.hpp"
#include "uncertainty/noise.hpp"

namespace trunk {

/// An interval of values; an end that is not bounded is infinite.
struct Interval {
  double lower = 0.0, upper = 0.0;
};

/// A fitted parameter and its uncertainty. Intervals are 95 %.
struct Estimate {
  std::string name, unit;
  double value = 0.0;
  double stderr_ = 0.0;  // in the unit; for Scale::factor it is the value times that of the logarithm
  double lower95 = 0.0, upper95 = 0.0;  // residuals correlated as AR(1)
  bool at_bound = false;
  bool identifiable = false;
  Interval naive95{};  // as if every sample were independent
  double prior = 0.0;  // deviation of the given prior, of the logarithm or amount; 0: no prior was given
  std::optional<Interval> open_profile{};  // the interval of a profile that is open: an end is infinite
};

/// A product of powers of the free parameters, and how exactly the data give it.
struct Combination {
  std::vector<double> powers;  // [asked for], the largest is 1
  double relative_stderr = 0.0;
};

/// The linear model of the fit at its best point, from which all intervals are derived.
struct LocalFit {
  Eigen::VectorXd x;                // coordinates
  Eigen::VectorXd residuals;        // [values] in deviations, whitened
  Eigen::MatrixXd rows;             // d residuals / d x: [values + priors, coordinates]
  Noise noise;                      // of the volume, in deviations
  std::vector<Block> blocks;        // of the values
  std::vector<double> deviations;   // of each block, the mean of those that divide its residuals
  std::vector<Noise> noises;        // of each block, in deviations; that of the volume comes first
  double freedom = 0.0;             // degrees of freedom of intervals
  Eigen::MatrixXd breaths;          // [values, breaths] breath minus mean, in deviations; 0 columns for one
  Eigen::MatrixXd unit_covariance;  // of x, as if all residuals had deviation 1
  Eigen::MatrixXd covariance;       // of x: AR(1) noise, and how breaths differ
  Eigen::MatrixXd naive_covariance;
};

/// Returns the noise that leaves these residuals of a block, after a fit with these rows. Of one number there
/// is none to be seen: it has the deviation that it is given.
Noise noise_of_block(const Objective& objective, std::size_t block, const Eigen::VectorXd& residuals,
                     const Eigen::MatrixXd& rows);

/// Returns the linear model at x, at which the model is `values`; none if the objective has no slopes there.
///
/// What was measured is the mean of `breaths` [breaths][values], and breaths differ by more than the noise of
/// their mean: each may have its own amplitude and shape. So the covariance is the sum of two. One is that of
/// correlated noise. The other is that of clusters, sum of d d' / (B (B - 1)), in which d is how far a breath
/// would move x if it were all that was measured. Intervals then have B - 1 degrees of freedom. (On
/// twins the intervals that also hold the error of the volume cover the truth in 95 to 100 % of 40 recordings
/// a family, see test_twins.cpp.) With one breath there is
/// the noise alone.
std::optional<LocalFit> local_fit(Objective& objective, const Eigen::VectorXd& x,
                                  const Eigen::VectorXd& values,
                                  const std::vector<std::vector<double>>& breaths = {});

/// Returns the covariance of x if the coordinate `held` is known; its row and column are 0.
Eigen::MatrixXd covariance_with_held(const LocalFit& fit, Eigen::Index held);

/// Local uncertainty at the best point.
struct Uncertainty {
  std::vector<Estimate> parameters;  // those asked for, in the order of the search space
  std::vector<Estimate> beside;      // the nuisance parameters
  Estimate ratio;                    // k_muscle / k_elasticity; the name is empty if k_muscle is not free
  Eigen::MatrixXd log_covariance;    // [asked for, asked for] of logarithms (amounts: of the values), AR(1)
  Eigen::MatrixXd correlation;       // of the same
  std::vector<Combination> combinations;  // best determined first; factors only
  double condition_number = 0.0;  // of the Jacobian in logarithms, with nuisance parameters eliminated
  double residual_autocorrelation = 0.0;  // lag 1
  double noise_autocorrelation = 0.0;     // of the noise that would leave such residuals
  double sigma_m3 = 0.0;                  // deviation of that noise
  double freedom = 0.0;                   // degrees of freedom of the intervals
  bool identifiable = false;
};

/// Concludes from the estimates whether all are identifiable. (parameters, ratio) => identifiable
void conclude(Uncertainty& uncertainty);

/// Returns estimates and intervals from the linear model. A free parameter is identifiable (our
/// choice) if its 95 % interval spans less than a factor of 4 (0.4 of its unit for Scale::amount), if it is
/// not within 2 % of a bound, and, for k_muscle, if k_elasticity is not at a bound. A profile that is open
/// makes it not identifiable later (see estimate).
Uncertainty assess(const Objective& objective, const LocalFit& fit);

/// Returns the estimates alone: as many numbers were fitted as measured, so the data hold nothing on
/// uncertainty.
Uncertainty without_uncertainty(const Objective& objective, const Eigen::VectorXd& x);

/// Returns the 97.5 % point of Student's t.
double t_quantile(double freedom);

}  // namespace trunk
