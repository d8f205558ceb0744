#pragma once

#include <limits>

#include "uncertainty/refit.hpp"

namespace trunk {

/// How much worse the fit becomes if one parameter is changed and all others are fitted again.
struct Profile {
  std::string name, unit;
  std::vector<double> value;     // [points] in the unit, increasing
  std::vector<double> deviance;  // [points] -2 log likelihood above its best, AR(1) (see deviance_scale)
  std::vector<bool> at_bound;    // [points] another parameter was at its bound: the profile is too high there
  /// Where the deviance passes the 95 % point of t^2; infinite if it does not within the points.
  Interval interval95{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
};

/// Returns the factor by which to multiply an increase of the sum of squares. The sum treats samples as
/// independent; with the factor it has the curvature for correlated residuals (vertical adjustment, Chandler
/// and Bate 2007). `direction` [coordinates], from the best point, is in the span of `moved`.
double deviance_scale(const LocalFit& fit, const Eigen::MatrixXd& moved, const Eigen::VectorXd& direction);

/// Returns the profiles of the parameters asked for, with `points` places on either side of the best value,
/// up to 1.5 half widths of its 95 % interval away or to the bounds.
std::vector<Profile> profiles(Objective& objective, const LocalFit& fit, int points = 4);

}  // namespace trunk
