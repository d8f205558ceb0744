#include "uncertainty/profiles.hpp"

#include <algorithm>
#include <cmath>

#include "linear_algebra/decompositions.hpp"

namespace trunk {
namespace {

constexpr double farthest = 1.5;  // half widths of the 95 % interval

/// The parameters themselves as coordinates (logarithms or amounts): y = to_values x.
struct Natural {
  Eigen::MatrixXd to_values, to_coordinates;

  explicit Natural(const SearchSpace& space)
      : to_values(space.values_by_coordinates()), to_coordinates(inverse_of(to_values)) {}

  Eigen::MatrixXd of(const Eigen::MatrixXd& covariance) const {
    return to_values * covariance * to_values.transpose();
  }
  /// Returns the directions of all parameters but i.
  Eigen::MatrixXd others(Eigen::Index i) const {
    Eigen::MatrixXd directions(to_coordinates.rows(), to_coordinates.cols() - 1);
    directions << to_coordinates.leftCols(i), to_coordinates.rightCols(to_coordinates.cols() - 1 - i);
    return directions;
  }
};

double natural(FreeParameter::Scale scale, double y) {
  return scale == FreeParameter::Scale::factor ? std::exp(y) : y;
}

double natural_coordinate(FreeParameter::Scale scale, double value) {
  return scale == FreeParameter::Scale::factor ? std::log(value) : value;
}

/// Returns 2 points + 1 places around `best`, up to 1.5 times `reach` away on either side or to the bounds.
std::vector<double> places(const FreeParameter& p, double best, double reach, int points) {
  const double below = std::min(farthest * reach, best - natural_coordinate(p.scale, p.lower));
  const double above = std::min(farthest * reach, natural_coordinate(p.scale, p.upper) - best);
  std::vector<double> at;
  for (int k = -points; k <= points; ++k) at.push_back(best + (k < 0 ? below : above) * k / points);
  return at;
}

/// Returns where the root of the deviance passes the quantile; the root is nearly linear in y. Infinite if it
/// does not.
double crossing(const std::vector<double>& y, const std::vector<double>& deviance, std::size_t best, int side,
                double quantile) {
  const auto root = [&](std::size_t k) { return std::sqrt(std::max(deviance[k], 0.0)); };
  for (std::size_t k = best; side > 0 ? k + 1 < y.size() : k > 0;) {
    const std::size_t next = side > 0 ? k + 1 : k - 1;
    if (root(next) >= quantile) {
      const double part = (quantile - root(k)) / (root(next) - root(k));
      return y[k] + part * (y[next] - y[k]);
    }
    k = next;
  }
  return side * std::numeric_limits<double>::infinity();
}

}  // namespace

double deviance_scale(const LocalFit& fit, const Eigen::MatrixXd& moved, const Eigen::VectorXd& direction) {
  const Eigen::MatrixXd pick = pseudo_inverse(moved);
  const Eigen::VectorXd d = pick * direction;
  const auto curvature = [&](const Eigen::MatrixXd& covariance) {
    const Eigen::MatrixXd within = pick * covariance * pick.transpose();
    return d.dot(solved_symmetric(within, d));
  };
  return curvature(fit.covariance) / curvature(fit.unit_covariance);
}

std::vector<Profile> profiles(Objective& objective, const LocalFit& fit, int points) {
  const SearchSpace& space = objective.space();
  const LeastSquares problem = objective.problem();
  const Natural natural_of(space);
  const Eigen::MatrixXd unit = natural_of.of(fit.unit_covariance), corrected = natural_of.of(fit.covariance);
  const double lowest = problem.at(fit.x).objective, quantile = t_quantile(fit.freedom);
  const Candidate candidate = space.decode(fit.x);

  std::vector<Profile> result;
  for (Eigen::Index i = 0; i < static_cast<Eigen::Index>(space.asked_for()); ++i) {
    const FreeParameter& p = space.parameter(static_cast<std::size_t>(i));
    const double best = natural_coordinate(p.scale, value_of(p, candidate));
    const std::vector<double> y = places(p, best, quantile * std::sqrt(corrected(i, i)), points);
    std::vector<Eigen::VectorXd> starts;
    for (const double at : y) {
      const Eigen::VectorXd moved =
          unit.col(i) * ((at - best) / unit(i, i));  // the others follow, to first order
      starts.push_back(fit.x + natural_of.to_coordinates * moved);
    }
    const std::vector<Refit> fits = refits(problem, fit, natural_of.others(i), starts);
    Profile profile{std::string(p.name), std::string(p.unit), {}, {}, {}};
    for (std::size_t k = 0; k < fits.size(); ++k) {
      profile.value.push_back(natural(p.scale, y[k]));
      profile.deviance.push_back((fits[k].objective - lowest) * unit(i, i) / corrected(i, i));
      profile.at_bound.push_back(fits[k].at_bound);
    }
    const auto centre = static_cast<std::size_t>(points);
    for (const int side : {-1, 1}) {
      const double at = crossing(y, profile.deviance, centre, side, quantile);
      (side < 0 ? profile.interval95.lower : profile.interval95.upper) =
          std::isfinite(at) ? natural(p.scale, at) : side * std::numeric_limits<double>::infinity();
    }
    result.push_back(std::move(profile));
  }
  return result;
}

}  // namespace trunk
