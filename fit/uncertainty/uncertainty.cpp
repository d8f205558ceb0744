#include "uncertainty/uncertainty.hpp"

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "uncertainty/verdict.hpp"

namespace trunk {
namespace {

constexpr double widest_identifiable = 4.0;  // upper over lower end of the 95 % interval
constexpr double at_bound_margin = 1e-4;     // in log coordinates

Estimate estimate(std::string name, std::string unit, double value, double log_stderr, double quantile) {
  const double spread = std::exp(std::min(quantile * log_stderr, 700.0));
  Estimate e{std::move(name), std::move(unit), value, value * log_stderr,
             value / spread,  value * spread,  false, spread * spread < widest_identifiable};
  return e;
}

/// Scale of the columns does not matter: parameters are compared as logarithms.
double condition_of(const Eigen::MatrixXd& jacobian) {
  const Eigen::VectorXd s = Eigen::JacobiSVD<Eigen::MatrixXd>(jacobian).singularValues();
  return s[0] / std::max(s[s.size() - 1], 1e-300);
}

/// As many numbers fitted as measured: nothing is left to tell how far to trust them.
Uncertainty exact(const Objective& objective, const Eigen::VectorXd& x) {
  const SearchSpace& space = objective.space();
  Candidate best = space.decode(x);
  Uncertainty u;
  const double unknown = std::nan("");
  for (std::size_t i = 0; i < space.size(); ++i) {
    const FreeParameter& p = space.parameter(i);
    u.parameters.push_back(
        {std::string(p.name), std::string(p.unit), p.field(best), unknown, unknown, unknown, false, true});
  }
  u.identifiable = true;
  u.residual_autocorrelation = u.condition_number = unknown;
  u.log_covariance = u.correlation = Eigen::MatrixXd::Constant(x.size(), x.size(), unknown);
  u.verdict =
      "Solved exactly from one number: no uncertainty can be given, and only the ratio "
      "k_muscle/k_elasticity is determined.";
  return u;
}

}  // namespace

Eigen::MatrixXd least_squares_covariance(const Eigen::MatrixXd& jacobian, double sigma, double rho) {
  const Eigen::MatrixXd pseudo_inverse = jacobian.completeOrthogonalDecomposition().pseudoInverse();
  const Eigen::Index n = jacobian.rows();
  Eigen::MatrixXd noise(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j)
      noise(i, j) = sigma * sigma * std::pow(rho, static_cast<double>(std::abs(i - j)));
  return pseudo_inverse * noise * pseudo_inverse.transpose();
}

double lag_one_autocorrelation(const Eigen::VectorXd& r) {
  const Eigen::Index n = r.size();
  const double energy = r.squaredNorm();
  if (n < 3 || energy <= 0.0) return 0.0;
  return r.head(n - 1).dot(r.tail(n - 1)) / energy;
}

Eigen::MatrixXd residual_jacobian(Objective& objective, const Eigen::VectorXd& x) {
  const double step = 1e-3;  // in log coordinates: truncation 1e-6, round-off far below
  const Eigen::VectorXd lower = objective.space().lower(), upper = objective.space().upper();
  Eigen::MatrixXd jacobian;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    Eigen::VectorXd ahead = x, behind = x;
    ahead[i] = std::min(x[i] + step, upper[i]);
    behind[i] = std::max(x[i] - step, lower[i]);
    const auto r_ahead = objective.residuals(ahead), r_behind = objective.residuals(behind);
    if (!r_ahead || !r_behind)
      throw std::runtime_error("the model cannot be simulated beside the best point: no uncertainty");
    if (jacobian.size() == 0) jacobian.resize(r_ahead->size(), x.size());
    jacobian.col(i) = (*r_ahead - *r_behind) / (ahead[i] - behind[i]);
  }
  return jacobian;
}

Eigen::MatrixXd timing_jacobian(const Objective& objective, const Eigen::VectorXd& x) {
  const SearchSpace& space = objective.space();
  const auto is_free = [&](std::string_view name) {
    for (std::size_t i = 0; i < space.size(); ++i)
      if (space.parameter(i).name == name) return true;
    return false;
  };
  const Candidate best = space.decode(x);
  Eigen::MatrixXd jacobian;
  const auto add_column = [&](double step, auto change) {
    Candidate ahead = best, behind = best;
    change(ahead, step);
    change(behind, -step);
    const auto r_ahead = objective.residuals_of(ahead), r_behind = objective.residuals_of(behind);
    if (!r_ahead || !r_behind)
      throw std::runtime_error("the model cannot be simulated beside the best point: no uncertainty");
    jacobian.conservativeResize(r_ahead->size(), jacobian.cols() + 1);
    jacobian.col(jacobian.cols() - 1) = (*r_ahead - *r_behind) / (2.0 * step);
  };
  for (const char* name : {"rise", "fast_fall", "slow_fall", "fast_fall_level"})
    if (!is_free(name))
      add_column(1e-3, [&](Candidate& c, double step) { free_parameter(name).field(c) *= std::exp(step); });
  add_column(1e-3, [](Candidate& c, double step) { c.activation.onset_s += step; });
  return jacobian;
}

Uncertainty assess(Objective& objective, const Eigen::VectorXd& x, bool timing_from_trace) {
  const SearchSpace& space = objective.space();
  const auto residuals = objective.residuals(x);
  if (!residuals) throw std::runtime_error("the best point cannot be simulated");
  if (residuals->size() <= x.size()) return exact(objective, x);
  const Eigen::MatrixXd jacobian = residual_jacobian(objective, x);
  Eigen::MatrixXd all = jacobian;
  if (timing_from_trace) {
    const Eigen::MatrixXd timing = timing_jacobian(objective, x);
    all.conservativeResize(Eigen::NoChange, jacobian.cols() + timing.cols());
    all.rightCols(timing.cols()) = timing;
  }
  const double freedom = std::max(1.0, static_cast<double>(residuals->size() - all.cols()));

  Uncertainty u;
  u.residual_autocorrelation = lag_one_autocorrelation(*residuals);
  u.sigma_m3 = std::sqrt(residuals->squaredNorm() / freedom);
  const double rho = std::clamp(u.residual_autocorrelation, 0.0, 0.999);
  const Eigen::MatrixXd covariance =
      least_squares_covariance(all, u.sigma_m3, rho).topLeftCorner(x.size(), x.size());
  const Eigen::MatrixXd to_logs = space.log_values_by_coordinates();
  u.log_covariance = to_logs * covariance * to_logs.transpose();
  const Eigen::VectorXd deviation = u.log_covariance.diagonal().cwiseSqrt().cwiseMax(1e-300);
  u.correlation =
      deviation.cwiseInverse().asDiagonal() * u.log_covariance * deviation.cwiseInverse().asDiagonal();
  u.condition_number = condition_of(jacobian * to_logs.inverse());

  const double quantile = gsl_cdf_tdist_Pinv(0.975, freedom);
  Candidate best = space.decode(x);
  const Eigen::VectorXd lower = space.lower(), upper = space.upper();
  for (std::size_t i = 0; i < space.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const FreeParameter& p = space.parameter(i);
    Estimate e = estimate(std::string(p.name), std::string(p.unit), p.field(best), deviation[row], quantile);
    e.at_bound = x[row] < lower[row] + at_bound_margin || x[row] > upper[row] - at_bound_margin;
    e.identifiable = e.identifiable && !e.at_bound;
    if (space.is_ratio(i))
      u.ratio = estimate("k_muscle/k_elasticity", "1", best.parameters.muscle / best.parameters.elasticity,
                         std::sqrt(covariance(row, row)), quantile);
    u.parameters.push_back(std::move(e));
  }
  u.identifiable =
      std::all_of(u.parameters.begin(), u.parameters.end(), [](const Estimate& e) { return e.identifiable; });
  u.verdict = verdict_of(u);
  return u;
}

}  // namespace trunk
