#include "uncertainty/noise.hpp"

#include <algorithm>
#include <cmath>

#include "linear_algebra/decompositions.hpp"

namespace trunk {
namespace {

constexpr double highest_rho = 0.999;
Eigen::MatrixXd whitened(const Eigen::MatrixXd& x, double rho) {
  const Eigen::Index n = x.rows();
  Eigen::MatrixXd w = x;
  w.bottomRows(n - 1) = (x.bottomRows(n - 1) - rho * x.topRows(n - 1)) / std::sqrt(1.0 - rho * rho);
  return w;
}

/// Returns what the whitened fitted directions leave of the whitened residuals.
Remainder white_remainder(const Eigen::VectorXd& residuals, const Eigen::MatrixXd& basis, double rho) {
  return remainder_along(whitened(basis, rho), whitened(residuals, rho));
}

/// Returns the restricted log likelihood of rho at the best deviation, up to a constant (Patterson and
/// Thompson 1971).
double restricted_likelihood(const Eigen::VectorXd& residuals, const Eigen::MatrixXd& basis, double rho) {
  const auto n = static_cast<double>(residuals.size()), p = static_cast<double>(basis.cols());
  const Remainder left = white_remainder(residuals, basis, rho);
  return -0.5 *
         ((n - 1.0) * std::log(1.0 - rho * rho) + left.log_determinant + (n - p) * std::log(left.squares));
}

}  // namespace

double autocorrelation(const Eigen::VectorXd& r, Eigen::Index lag) {
  const Eigen::Index n = r.size();
  const double energy = r.squaredNorm();
  if (n < lag + 2 || energy <= 0.0) return 0.0;
  return r.head(n - lag).dot(r.tail(n - lag)) / energy;
}

Noise estimate_noise(const Eigen::VectorXd& residuals, const Eigen::MatrixXd& jacobian) {
  const Eigen::MatrixXd basis = orthonormal_basis(jacobian);
  Noise noise;
  noise.freedom = std::max(1.0, static_cast<double>(residuals.size() - basis.cols()));
  noise.white_deviation = noise.deviation = std::sqrt(residuals.squaredNorm() / noise.freedom);
  if (noise.white_deviation < 1e-9) return noise;  // only rounding errors

  constexpr int steps = 40;  // even in log(1 - rho)
  Eigen::ArrayXd log_rest(steps + 1), log_deviation(steps + 1), likelihood(steps + 1);
  for (int k = 0; k <= steps; ++k) {
    log_rest[k] = std::log(1.0 - highest_rho) * k / steps;
    const double rho = 1.0 - std::exp(log_rest[k]);
    log_deviation[k] = 0.5 * std::log(white_remainder(residuals, basis, rho).squares / noise.freedom);
    likelihood[k] = restricted_likelihood(residuals, basis, rho);
  }
  const Eigen::ArrayXd weight = (likelihood - likelihood.maxCoeff()).exp();
  noise.rho = 1.0 - std::exp((weight * log_rest).sum() / weight.sum());
  noise.deviation = std::exp((weight * log_deviation).sum() / weight.sum());
  return noise;
}

double noise_correlation(const Eigen::VectorXd& mean, const std::vector<std::vector<double>>& breaths) {
  constexpr std::size_t fewest = 3;
  constexpr double highest = 0.98;
  if (breaths.size() < fewest) return 0.0;
  double squares = 0.0, products = 0.0;
  const Eigen::Index last = mean.size() - 1;
  for (const std::vector<double>& volume : breaths) {
    const Eigen::VectorXd breath = Eigen::VectorXd::Map(volume.data(), mean.size());
    const Eigen::VectorXd left = breath - breath.dot(mean) / mean.squaredNorm() * mean;
    squares += left.head(last).squaredNorm();
    products += left.head(last).dot(left.tail(last));
  }
  return squares > 0.0 ? std::clamp(products / squares, 0.0, highest) : 0.0;
}

double ar1_bic(const Eigen::VectorXd& r, std::size_t parameters) {
  const Eigen::Index n = r.size();
  const auto count = static_cast<double>(n);
  const double rho = std::clamp(autocorrelation(r, 1), -highest_rho, highest_rho);
  const double innovations =
      (1.0 - rho * rho) * r[0] * r[0] + (r.tail(n - 1) - rho * r.head(n - 1)).squaredNorm();
  const double fit = count * std::log(std::max(innovations, 1e-300) / count) - std::log(1.0 - rho * rho);
  return fit + (static_cast<double>(parameters) + 2.0) * std::log(count);
}

Eigen::MatrixXd noise_covariance(Eigen::Index n, double deviation, double rho) {
  Eigen::VectorXd power(n);
  for (Eigen::Index k = 0; k < n; ++k)
    power[k] = deviation * deviation * std::pow(rho, static_cast<double>(k));
  Eigen::MatrixXd s(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j) s(i, j) = power[std::abs(i - j)];
  return s;
}

Eigen::MatrixXd least_squares_covariance(const Eigen::MatrixXd& rows, const Eigen::MatrixXd& noise) {
  const Eigen::MatrixXd inverse = pseudo_inverse(rows);
  const Eigen::MatrixXd data = inverse.leftCols(noise.rows()),
                        known = inverse.rightCols(rows.rows() - noise.rows());
  return data * noise * data.transpose() + known * known.transpose();
}

}  // namespace trunk
