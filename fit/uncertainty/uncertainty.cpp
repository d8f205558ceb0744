#include "uncertainty/uncertainty.hpp"

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>

#include "linear_algebra/decompositions.hpp"

namespace trunk {
namespace {

using Scale = FreeParameter::Scale;

constexpr double widest_identifiable = 4.0;         // upper over lower end of the 95 % interval
constexpr double widest_identifiable_amount = 0.4;  // upper minus lower end
constexpr double at_bound_margin = 0.02;            // in coordinates: searches end beside a bound

Interval interval(Scale scale, double value, double deviation, double quantile) {
  const double reach = quantile * deviation;
  if (scale == Scale::amount) return {value - reach, value + reach};
  const double spread = std::exp(std::min(reach, 700.0));
  return {value / spread, value * spread};
}

struct Deviations {  // of the logarithm, or of the amount
  double corrected, naive;
};

Estimate estimate(std::string name, std::string unit, Scale scale, double value, Deviations d,
                  const LocalFit& fit) {
  const Interval wide = interval(scale, value, d.corrected, t_quantile(fit.freedom));
  Estimate e{std::move(name), std::move(unit),
             value,           scale == Scale::factor ? value * d.corrected : d.corrected,
             wide.lower,      wide.upper};
  e.naive95 = interval(scale, value, d.naive, t_quantile(fit.noise.freedom));
  e.identifiable = scale == Scale::factor ? wide.upper < widest_identifiable * wide.lower
                                          : wide.upper - wide.lower < widest_identifiable_amount;
  return e;
}

/// Returns the condition number of the Jacobian in logarithms, so the units of the parameters do not matter.
double condition_of(const Eigen::MatrixXd& covariance) {
  const Eigen::VectorXd e = symmetric_eigen(covariance).values;
  return std::sqrt(e[e.size() - 1] / std::max(e[0], 1e-300));
}

std::vector<Combination> combinations_of(const Eigen::MatrixXd& log_covariance, const SearchSpace& space) {
  std::vector<Combination> result;
  for (std::size_t i = 0; i < space.asked_for(); ++i)
    if (space.parameter(i).scale == Scale::amount) return result;
  const SymmetricEigen eigen = symmetric_eigen(log_covariance);
  for (Eigen::Index k = 0; k < log_covariance.rows(); ++k) {
    Eigen::VectorXd v = eigen.vectors.col(k);
    Eigen::Index largest = 0;
    v.cwiseAbs().maxCoeff(&largest);
    const double scale = 1.0 / v[largest];
    v *= scale;
    result.push_back(
        {{v.data(), v.data() + v.size()}, std::sqrt(std::max(eigen.values[k], 0.0)) * std::abs(scale)});
  }
  return result;
}

}  // namespace

double t_quantile(double freedom) {
  return gsl_cdf_tdist_Pinv(0.975, freedom);
}

namespace {

/// Returns each breath minus the mean, in deviations, [samples, breaths].
Eigen::MatrixXd apart(const std::vector<std::vector<double>>& breaths, const Objective& objective) {
  const auto count = static_cast<Eigen::Index>(breaths.size());
  if (count < 2) return Eigen::MatrixXd(objective.samples(), 0);
  Eigen::MatrixXd all(objective.samples(), count);
  for (Eigen::Index b = 0; b < count; ++b) {
    const auto& breath = breaths[static_cast<std::size_t>(b)];
    all.col(b) = Eigen::VectorXd::Map(breath.data(), objective.samples()) - objective.measured();
  }
  return objective.whitened(all);
}

/// Returns the covariance of the noise of all values: blocks do not share noise.
Eigen::MatrixXd blockwise_covariance(const std::vector<Block>& blocks, const std::vector<Noise>& noises) {
  const Eigen::Index n = blocks.back().first + blocks.back().count;
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(n, n);
  for (std::size_t b = 0; b < blocks.size(); ++b)
    all.block(blocks[b].first, blocks[b].first, blocks[b].count, blocks[b].count) =
        noise_covariance(blocks[b].count, noises[b].deviation, noises[b].rho);
  return all;
}

/// Returns the covariance of an estimate with these rows: noise, and clusters of breaths.
Eigen::MatrixXd covariance_of(const Eigen::MatrixXd& rows, const Eigen::MatrixXd& noise,
                              const Eigen::MatrixXd& breaths) {
  const Eigen::Index n = breaths.rows();
  Eigen::MatrixXd covariance = least_squares_covariance(rows, noise);
  if (breaths.cols() < 2) return covariance;
  const Eigen::MatrixXd moved = pseudo_inverse(rows).leftCols(n) * breaths;
  const auto count = static_cast<double>(breaths.cols());
  return covariance + moved * moved.transpose() / (count * (count - 1.0));
}

}  // namespace

Noise noise_of_block(const Objective& objective, std::size_t block, const Eigen::VectorXd& residuals,
                     const Eigen::MatrixXd& rows) {
  const Block& b = objective.blocks()[block];
  if (b.count == 1) return {0.0, 1.0, 1.0, 1.0};
  const Eigen::MatrixXd own = rows.middleRows(b.first, b.count);
  const Eigen::MatrixXd& nuisance = objective.nuisance(block);
  if (block == 0 || nuisance.cols() == 0) return estimate_noise(residuals.segment(b.first, b.count), own);
  Eigen::MatrixXd followed(b.count, own.cols() + nuisance.cols());
  followed << own, nuisance;
  return estimate_noise(residuals.segment(b.first, b.count), followed);
}

std::optional<LocalFit> local_fit(Objective& objective, const Eigen::VectorXd& x,
                                  const Eigen::VectorXd& values,
                                  const std::vector<std::vector<double>>& breaths) {
  const auto rows = jacobian(objective.problem(), x);
  if (!rows) return std::nullopt;
  const Eigen::Index n = objective.samples();
  LocalFit fit;
  fit.x = x;
  fit.residuals = objective.whitened(values - objective.measured());
  fit.rows = *rows;
  fit.blocks = objective.blocks();
  std::vector<Noise> white;
  for (const Block& b : fit.blocks)
    fit.deviations.push_back(objective.deviation().segment(b.first, b.count).mean());
  for (std::size_t b = 0; b < fit.blocks.size(); ++b) {
    fit.noises.push_back(noise_of_block(objective, b, fit.residuals, fit.rows));
    white.push_back(fit.noises.back());
    white.back().rho = 0.0;
    white.back().deviation = white.back().white_deviation;
  }
  fit.noise = fit.noises.front();
  fit.breaths = apart(breaths, objective);
  fit.freedom = fit.breaths.cols() > 1 ? static_cast<double>(fit.breaths.cols() - 1) : fit.noise.freedom;
  fit.unit_covariance = least_squares_covariance(fit.rows, Eigen::MatrixXd::Identity(n, n));
  fit.covariance = covariance_of(fit.rows, blockwise_covariance(fit.blocks, fit.noises), fit.breaths);
  fit.naive_covariance = least_squares_covariance(fit.rows, blockwise_covariance(fit.blocks, white));
  return fit;
}

Eigen::MatrixXd covariance_with_held(const LocalFit& fit, Eigen::Index held) {
  const Eigen::Index n = fit.x.size();
  std::vector<Eigen::Index> others;
  for (Eigen::Index i = 0; i < n; ++i)
    if (i != held) others.push_back(i);
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(n, n);
  if (!others.empty())
    covariance(others, others) = covariance_of(fit.rows(Eigen::all, others),
                                               blockwise_covariance(fit.blocks, fit.noises), fit.breaths);
  return covariance;
}

Uncertainty assess(const Objective& objective, const LocalFit& fit) {
  const SearchSpace& space = objective.space();
  const auto asked_for = static_cast<Eigen::Index>(space.asked_for());
  const Eigen::MatrixXd to_values = space.values_by_coordinates();
  const Eigen::MatrixXd corrected = to_values * fit.covariance * to_values.transpose();
  const Eigen::MatrixXd naive = to_values * fit.naive_covariance * to_values.transpose();

  Uncertainty u;
  const Block& volume = fit.blocks.front();
  u.residual_autocorrelation = autocorrelation(fit.residuals.head(volume.count), 1);
  u.noise_autocorrelation = fit.noise.rho;
  u.sigma_m3 = fit.noise.deviation * objective.deviation().head(volume.count).mean();
  u.freedom = fit.freedom;
  u.log_covariance = corrected.topLeftCorner(asked_for, asked_for);
  const Eigen::VectorXd deviation = u.log_covariance.diagonal().cwiseSqrt().cwiseMax(1e-300);
  u.correlation =
      deviation.cwiseInverse().asDiagonal() * u.log_covariance * deviation.cwiseInverse().asDiagonal();
  u.condition_number = condition_of(naive.topLeftCorner(asked_for, asked_for));
  u.combinations = combinations_of(u.log_covariance, space);

  const Candidate best = space.decode(fit.x);
  const Eigen::VectorXd lower = space.lower(), upper = space.upper();
  for (std::size_t i = 0; i < space.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const FreeParameter& p = space.parameter(i);
    Estimate e = estimate(std::string(p.name), std::string(p.unit), p.scale, value_of(p, best),
                          {std::sqrt(corrected(row, row)), std::sqrt(naive(row, row))}, fit);
    e.at_bound = fit.x[row] < lower[row] + at_bound_margin || fit.x[row] > upper[row] - at_bound_margin;
    e.identifiable = e.identifiable && !e.at_bound;
    e.prior = space.given_deviation(i);
    if (space.is_ratio(i))
      u.ratio = estimate(
          "k_muscle/k_elasticity", "1", Scale::factor, best.parameters.muscle / best.parameters.elasticity,
          {std::sqrt(fit.covariance(row, row)), std::sqrt(fit.naive_covariance(row, row))}, fit);
    (i < space.asked_for() ? u.parameters : u.beside).push_back(std::move(e));
  }
  // k_muscle is tied to k_elasticity: at a bound, neither is identifiable.
  const auto named = [&](const char* name) {
    return std::find_if(u.parameters.begin(), u.parameters.end(),
                        [&](const Estimate& e) { return e.name == name; });
  };
  const auto elasticity = named("k_elasticity"), muscle = named("k_muscle");
  if (elasticity != u.parameters.end() && muscle != u.parameters.end() && elasticity->at_bound)
    muscle->identifiable = false;
  conclude(u);
  return u;
}

void conclude(Uncertainty& u) {
  u.identifiable =
      std::all_of(u.parameters.begin(), u.parameters.end(), [](const Estimate& e) { return e.identifiable; });
}

Uncertainty without_uncertainty(const Objective& objective, const Eigen::VectorXd& x) {
  const SearchSpace& space = objective.space();
  const Candidate best = space.decode(x);
  Uncertainty u;
  const double unknown = std::nan("");
  for (std::size_t i = 0; i < space.asked_for(); ++i) {
    const FreeParameter& p = space.parameter(i);
    Estimate e{
        std::string(p.name), std::string(p.unit), value_of(p, best), unknown, unknown, unknown, false, true};
    e.naive95 = {unknown, unknown};
    u.parameters.push_back(e);
  }
  u.identifiable = true;
  u.residual_autocorrelation = u.noise_autocorrelation = u.condition_number = unknown;
  const auto n = static_cast<Eigen::Index>(space.asked_for());
  u.log_covariance = u.correlation = Eigen::MatrixXd::Constant(n, n, unknown);
  return u;
}

}  // namespace trunk
