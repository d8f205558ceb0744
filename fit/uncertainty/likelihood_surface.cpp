#include "uncertainty/likelihood_surface.hpp"

#include <gsl/gsl_cdf.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace trunk {
namespace {

constexpr double grid_reach = 4.0;  // standard errors

std::vector<double> grid(double centre, double deviation, double lower, double upper, int points) {
  const double low = std::max(centre - grid_reach * deviation, lower),
               high = std::min(centre + grid_reach * deviation, upper);
  std::vector<double> at;
  for (int i = 0; i < points; ++i) at.push_back(low + (high - low) * i / (points - 1));
  return at;
}

/// Returns where the deviance passes the threshold between an inner and an outer point of a grid line. The
/// root of the deviance is taken as linear between them.
double edge(double inner, double outer, double d_inner, double d_outer, double threshold) {
  const double a = std::sqrt(std::max(d_inner, 0.0)), b = std::sqrt(d_outer), at = std::sqrt(threshold);
  return std::isfinite(b) ? inner + (outer - inner) * (at - a) / (b - a) : inner;
}

/// Widens the span by the part of one grid line that is below the threshold. => span, closed
void widen(Interval& span, const std::vector<double>& at, const std::vector<double>& deviance,
           double threshold, bool& closed) {
  for (std::size_t k = 0; k < at.size(); ++k) {
    if (!(deviance[k] <= threshold)) continue;
    const bool first = k == 0, last = k + 1 == at.size();
    closed = closed && !first && !last;
    const double low = first || deviance[k - 1] <= threshold
                           ? at[k]
                           : edge(at[k], at[k - 1], deviance[k], deviance[k - 1], threshold);
    const double high = last || deviance[k + 1] <= threshold
                            ? at[k]
                            : edge(at[k], at[k + 1], deviance[k], deviance[k + 1], threshold);
    span = {std::min(span.lower, low), std::max(span.upper, high)};
  }
}

}  // namespace

LikelihoodSurface likelihood_surface(Objective& objective, const LocalFit& fit, int points) {
  const SearchSpace& space = objective.space();
  const LeastSquares problem = objective.problem();
  const Eigen::VectorXd lower = space.lower(), upper = space.upper();
  const Eigen::Matrix2d block = fit.unit_covariance.topLeftCorner(2, 2);
  const Eigen::MatrixXd follow = fit.unit_covariance.leftCols(2) * block.inverse();
  const Eigen::MatrixXd moved = Eigen::MatrixXd::Identity(fit.x.size(), 2);

  LikelihoodSurface surface;
  std::vector<double> at[2];
  for (Eigen::Index i = 0; i < 2; ++i) {
    const auto k = static_cast<std::size_t>(i);
    at[i] = grid(fit.x[i], std::sqrt(fit.covariance(i, i)), lower[i], upper[i], points);
    const FreeParameter& p = space.parameter(k);
    surface.names[i] = space.is_ratio(k) ? "k_muscle/k_elasticity" : std::string(p.name);
    surface.units[i] = space.is_ratio(k) ? "1" : std::string(p.unit);
  }
  std::vector<Eigen::VectorXd> nodes;
  for (const double first : at[0])
    for (const double second : at[1])
      nodes.push_back(problem.inside(fit.x + follow * Eigen::Vector2d(first - fit.x[0], second - fit.x[1])));
  const double lowest = problem.at(fit.x).objective;
  const Eigen::MatrixXd beside =
      Eigen::MatrixXd::Identity(fit.x.size(), fit.x.size()).rightCols(fit.x.size() - 2);
  for (const Refit& node : refits(problem, fit, beside, nodes, {}, 3)) {
    const Eigen::VectorXd away = node.x - fit.x;
    const double scale = away.head(2).norm() > 0.0 ? deviance_scale(fit, moved, away) : 1.0;
    surface.deviance.push_back(scale * std::max(node.objective - lowest, 0.0));
  }

  surface.threshold95 = 2.0 * gsl_cdf_fdist_Pinv(0.95, 2.0, fit.freedom);
  surface.closed = true;
  const auto n = static_cast<std::size_t>(points);
  Interval span[2];
  for (int i = 0; i < 2; ++i) span[i] = {fit.x[i], fit.x[i]};
  for (std::size_t line = 0; line < n; ++line) {
    std::vector<double> row, column;
    for (std::size_t k = 0; k < n; ++k) {
      row.push_back(surface.deviance[line * n + k]);
      column.push_back(surface.deviance[k * n + line]);
    }
    widen(span[1], at[1], row, surface.threshold95, surface.closed);
    widen(span[0], at[0], column, surface.threshold95, surface.closed);
  }
  for (int i = 0; i < 2; ++i) {
    const bool factor = space.parameter(static_cast<std::size_t>(i)).scale == FreeParameter::Scale::factor;
    const auto natural = [&](double y) {
      return factor ? std::exp(y) : y * space.values_by_coordinates()(i, i);
    };
    for (const double y : at[i]) surface.axis[i].push_back(natural(y));
    surface.region95[i] = {natural(span[i].lower), natural(span[i].upper)};
  }
  return surface;
}

}  // namespace trunk
