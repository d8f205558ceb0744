#include "problem/measured_curve.hpp"

#include <algorithm>
#include <cmath>

#include "math/median.hpp"

namespace trunk {
namespace {

constexpr double trusted_to = 0.01, independent_samples = 20.0;
constexpr double huber_corner = 1.345, student_freedom = 4.0;

double loss_of(double z, Loss loss) {
  if (loss == Loss::huber)
    return std::abs(z) <= huber_corner ? z * z : huber_corner * (2.0 * std::abs(z) - huber_corner);
  return (student_freedom + 1.0) * std::log1p(z * z / student_freedom);
}

double half_loss_slope(double z, Loss loss) {
  if (loss == Loss::huber) return std::clamp(z, -huber_corner, huber_corner);
  return (student_freedom + 1.0) * z / (student_freedom + z * z);
}

}  // namespace

double MeasuredCurve::tidal_volume() const {
  return *std::max_element(delta_v.begin(), delta_v.end());
}

Eigen::VectorXd sample_deviation(const MeasuredCurve& measured) {
  const auto n = static_cast<Eigen::Index>(measured.delta_v.size());
  if (!measured.sigma_m3.empty()) return Eigen::VectorXd::Map(measured.sigma_m3.data(), n);
  const double shared_by = std::max(1.0, static_cast<double>(n) / independent_samples);
  return Eigen::VectorXd::Constant(n, trusted_to * std::abs(measured.tidal_volume()) * std::sqrt(shared_by));
}

Eigen::VectorXd robust_residuals(const Eigen::VectorXd& residuals, Loss loss, double scale) {
  if (loss == Loss::squares) return residuals;
  return residuals.unaryExpr(
      [&](double r) { return std::copysign(scale * std::sqrt(loss_of(r / scale, loss)), r); });
}

Eigen::VectorXd robust_slopes(const Eigen::VectorXd& residuals, Loss loss, double scale) {
  if (loss == Loss::squares) return Eigen::VectorXd::Ones(residuals.size());
  return residuals.unaryExpr([&](double r) {
    const double z = std::max(std::abs(r / scale), 1e-6);  // the slope is even, and finite at 0
    return half_loss_slope(z, loss) / std::sqrt(loss_of(z, loss));
  });
}

double median_deviation(const Eigen::VectorXd& residuals) {
  std::vector<double> size(residuals.data(), residuals.data() + residuals.size());
  for (double& r : size) r = std::abs(r);
  return 1.4826 * upper_median(std::move(size));
}

Eigen::VectorXd sampled(const std::vector<double>& curve, double dt_s, const std::vector<double>& time_s) {
  Eigen::VectorXd values(static_cast<Eigen::Index>(time_s.size()));
  for (std::size_t i = 0; i < time_s.size(); ++i) {
    const double at = std::clamp(time_s[i] / dt_s, 0.0, static_cast<double>(curve.size() - 1));
    const auto before = std::min(static_cast<std::size_t>(at), curve.size() - 2);
    const double part = at - static_cast<double>(before);
    values[static_cast<Eigen::Index>(i)] = curve[before] + part * (curve[before + 1] - curve[before]);
  }
  return values;
}

Eigen::VectorXd as_measured(const MeasuredCurve& measured, const std::vector<double>& curve, double dt_s) {
  return as_measured(measured, curve, curve, dt_s);
}

Eigen::VectorXd as_measured(const MeasuredCurve& measured, const std::vector<double>& curve,
                            const std::vector<double>& derivative, double dt_s) {
  if (!measured.is_tidal_volume()) return sampled(derivative, dt_s, measured.time_s);
  const auto highest = std::max_element(curve.begin(), curve.end()) - curve.begin();
  return Eigen::VectorXd::Constant(1, derivative[static_cast<std::size_t>(highest)]);
}

}  // namespace trunk
