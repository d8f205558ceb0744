#pragma once

#include <limits>

#include "uncertainty/refit.hpp"

namespace trunk {

/// How much worse the fit becomes as one parameter is moved and all others follow.
struct Profile {
  std::string name, unit;
  std::vector<double> value;     // [points] in the unit, increasing
  std::vector<double> deviance;  // [points] -2 log likelihood above its best, AR(1) (see deviance_scale)
  std::vector<bool> at_bound;    // [points] another parameter sat on its bound: the profile is too high there
  /// Where the deviance passes the 95 % point of t^2; infinite where it does not within the points.
  Interval interval95{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
};

/// The sum of squares counts samples as independent; multiplied by this it has the curvature that correlated
/// residuals leave (vertical adjustment of Chandler and Bate 2007). `direction` [coordinates], from the best
/// point, is among `moved`.
double deviance_scale(const LocalFit& fit, const Eigen::MatrixXd& moved, const Eigen::VectorXd& direction);

/// Profiles of the parameters asked for, at `points` places on either side of the best, up to 1.5
/// times the half width of its 95 % interval away or to the bounds.
std::vector<Profile> profiles(Objective& objective, const LocalFit& fit, int points = 4);

}  // namespace trunk
