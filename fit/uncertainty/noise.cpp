#include "uncertainty/noise.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace trunk {
namespace {

constexpr double highest_rho = 0.999;

/// What is left of noise of covariance S after a fit: M S M with M = 1 - Q Q', Q a basis of what was fitted.
struct Remainder {
  Eigen::MatrixXd covariance;

  Remainder(const Eigen::MatrixXd& basis, double rho) {
    const Eigen::MatrixXd s = noise_covariance(basis.rows(), 1.0, rho);
    const Eigen::MatrixXd sq = s * basis;
    covariance = s - basis * sq.transpose() - sq * basis.transpose() +
                 basis * (basis.transpose() * sq) * basis.transpose();
  }
  double autocorrelation() const { return covariance.diagonal(1).sum() / covariance.trace(); }
};

Eigen::MatrixXd basis_of(const Eigen::MatrixXd& jacobian) {
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(jacobian);
  const Eigen::MatrixXd q = qr.householderQ() * Eigen::MatrixXd::Identity(jacobian.rows(), qr.rank());
  return q;
}

double matching_rho(const Eigen::MatrixXd& basis, double seen) {
  double low = 0.0, high = highest_rho;
  if (Remainder(basis, low).autocorrelation() >= seen) return low;
  if (Remainder(basis, high).autocorrelation() <= seen) return high;
  for (int i = 0; i < 20; ++i) {
    const double middle = 0.5 * (low + high);
    (Remainder(basis, middle).autocorrelation() < seen ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

double lag_one_autocorrelation(const Eigen::VectorXd& r) {
  const Eigen::Index n = r.size();
  const double energy = r.squaredNorm();
  if (n < 3 || energy <= 0.0) return 0.0;
  return r.head(n - 1).dot(r.tail(n - 1)) / energy;
}

Noise estimate_noise(const Eigen::VectorXd& residuals, const Eigen::MatrixXd& jacobian) {
  const Eigen::MatrixXd basis = basis_of(jacobian);
  Noise noise;
  noise.white_freedom = std::max(1.0, static_cast<double>(residuals.size() - basis.cols()));
  noise.white_deviation = std::sqrt(residuals.squaredNorm() / noise.white_freedom);
  noise.rho = matching_rho(basis, lag_one_autocorrelation(residuals));
  const Remainder left(basis, noise.rho);
  const double trace = left.covariance.trace();
  noise.deviation = std::sqrt(residuals.squaredNorm() / trace);
  noise.freedom = std::max(1.0, trace * trace / left.covariance.squaredNorm());
  return noise;
}

double ar1_bic(const Eigen::VectorXd& r, std::size_t parameters) {
  const Eigen::Index n = r.size();
  const auto count = static_cast<double>(n);
  const double rho = std::clamp(lag_one_autocorrelation(r), -highest_rho, highest_rho);
  const double innovations =
      (1.0 - rho * rho) * r[0] * r[0] + (r.tail(n - 1) - rho * r.head(n - 1)).squaredNorm();
  const double fit = count * std::log(std::max(innovations, 1e-300) / count) - std::log(1.0 - rho * rho);
  return fit + (static_cast<double>(parameters) + 2.0) * std::log(count);
}

Eigen::MatrixXd noise_covariance(Eigen::Index n, double deviation, double rho) {
  Eigen::VectorXd power(n);
  for (Eigen::Index k = 0; k < n; ++k) power[k] = deviation * deviation * std::pow(rho, static_cast<double>(k));
  Eigen::MatrixXd s(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j) s(i, j) = power[std::abs(i - j)];
  return s;
}

Eigen::MatrixXd least_squares_covariance(const Eigen::MatrixXd& rows, const Eigen::MatrixXd& noise) {
  const Eigen::MatrixXd inverse = rows.completeOrthogonalDecomposition().pseudoInverse();
  const Eigen::MatrixXd data = inverse.leftCols(noise.rows()), known = inverse.rightCols(rows.rows() - noise.rows());
  return data * noise * data.transpose() + known * known.transpose();
}

}  // namespace trunk
