#include "problem/measured_curve.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

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

namespace {

Eigen::VectorXd volume_deviation(const MeasuredCurve& measured) {
  const auto n = static_cast<Eigen::Index>(measured.delta_v.size());
  if (!measured.sigma_m3.empty()) return Eigen::VectorXd::Map(measured.sigma_m3.data(), n);
  const double shared_by = std::max(1.0, static_cast<double>(n) / independent_samples);
  return Eigen::VectorXd::Constant(n, trusted_to * std::abs(measured.tidal_volume()) * std::sqrt(shared_by));
}

/// Returns the slope of even samples, by central differences.
Eigen::VectorXd slope_of(const Eigen::VectorXd& value) {
  const Eigen::Index n = value.size();
  Eigen::VectorXd slope = Eigen::VectorXd::Zero(n);
  for (Eigen::Index i = 1; i + 1 < n; ++i) slope[i] = 0.5 * (value[i + 1] - value[i - 1]);
  return slope;
}

/// Returns what a channel shows of a breath. A descent is positive.
Eigen::VectorXd curve_for(ChannelKind kind, const SeenBreath& breath) {
  switch (kind) {
    case ChannelKind::pleural:
      return breath.pleural_Pa;
    case ChannelKind::gastric:
      return breath.abdominal_Pa;
    case ChannelKind::transdiaphragmatic:
      return breath.abdominal_Pa - breath.pleural_Pa;
    case ChannelKind::excursion:
      return -breath.right_dome_m;
    case ChannelKind::emg:
      return breath.activation;
    case ChannelKind::airway:
      break;  // it drives the model
  }
  throw std::logic_error("a fit does not compare the pressure of the airway");
}

}  // namespace

Eigen::VectorXd mapped(const std::vector<double>& values) {
  return Eigen::VectorXd::Map(values.data(), static_cast<Eigen::Index>(values.size()));
}

std::vector<Block> blocks_of(const MeasuredCurve& measured) {
  std::vector<Block> blocks{{0, static_cast<Eigen::Index>(measured.delta_v.size())}};
  for (const MeasuredObservable& o : measured.beside)
    blocks.push_back({blocks.back().first + blocks.back().count, static_cast<Eigen::Index>(o.value.size())});
  return blocks;
}

Eigen::VectorXd values_of(const MeasuredCurve& measured) {
  const std::vector<Block> blocks = blocks_of(measured);
  Eigen::VectorXd all(blocks.back().first + blocks.back().count);
  all.head(blocks.front().count) = mapped(measured.delta_v);
  for (std::size_t b = 1; b < blocks.size(); ++b) {
    const MeasuredObservable& o = measured.beside[b - 1];
    auto part = all.segment(blocks[b].first, blocks[b].count);
    if (o.kind == ChannelKind::emg)
      part.setZero();
    else
      part = mapped(o.value);
  }
  return all;
}

Eigen::MatrixXd nuisance_of(const MeasuredCurve& measured, std::size_t block) {
  const Eigen::Index n = blocks_of(measured)[block].count;
  if (block == 0 || measured.beside[block - 1].is_number()) return Eigen::MatrixXd(n, 0);
  const MeasuredObservable& o = measured.beside[block - 1];
  const Eigen::VectorXd offset = Eigen::VectorXd::Ones(n);
  if (o.kind == ChannelKind::emg) {
    Eigen::MatrixXd courses(n, 3);
    courses << offset, mapped(o.value), slope_of(mapped(o.value));
    return courses;
  }
  if (o.kind != ChannelKind::pleural && o.kind != ChannelKind::transdiaphragmatic) return offset;
  Eigen::MatrixXd courses(n, 2);
  courses << offset, Eigen::VectorXd::LinSpaced(n, -1.0, 1.0);
  return courses;
}

SeenBreath seen(const MeasuredCurve& measured, const BreathCurves& curves, double dt_s) {
  const auto at = [&](const std::vector<double>& curve) { return sampled(curve, dt_s, measured.time_s); };
  if (measured.beside.empty()) return {at(curves.delta_v), {}, {}, {}, {}};
  return {at(curves.delta_v), at(curves.abdominal_Pa), at(curves.pleural_Pa), at(curves.right_dome_m), {}};
}

Eigen::VectorXd as_measured(const MeasuredCurve& measured, const SeenBreath& breath,
                            const SeenBreath& derivative) {
  const std::vector<Block> blocks = blocks_of(measured);
  Eigen::VectorXd all(blocks.back().first + blocks.back().count);
  all.head(blocks.front().count) = derivative.delta_v;
  Eigen::Index highest = 0;
  breath.delta_v.maxCoeff(&highest);
  for (std::size_t b = 1; b < blocks.size(); ++b) {
    const MeasuredObservable& o = measured.beside[b - 1];
    const Eigen::VectorXd curve = curve_for(o.kind, derivative);
    auto part = all.segment(blocks[b].first, blocks[b].count);
    if (o.is_number())
      part[0] = curve[highest];
    else
      part = curve;
  }
  return all;
}

Eigen::VectorXd activation_at(const MeasuredCurve& measured, const BreathActivation<double>& activation,
                              const TimeGrid& grid) {
  Eigen::VectorXd values(static_cast<Eigen::Index>(measured.time_s.size()));
  for (Eigen::Index i = 0; i < values.size(); ++i)
    values[i] = grid.active(activation, measured.time_s[static_cast<std::size_t>(i)]);
  return values;
}

Eigen::VectorXd sample_deviation(const MeasuredCurve& measured) {
  const std::vector<Block> blocks = blocks_of(measured);
  Eigen::VectorXd all(blocks.back().first + blocks.back().count);
  all.head(blocks.front().count) = volume_deviation(measured);
  for (std::size_t b = 1; b < blocks.size(); ++b)
    all.segment(blocks[b].first, blocks[b].count).setConstant(measured.beside[b - 1].deviation);
  return all;
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
