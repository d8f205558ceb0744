#pragma once

#include <Eigen/Core>
#include <vector>

namespace trunk {

/// What the model is fitted to: a volume curve at increasing times from 0, or only its highest value, at
/// whatever time (one entry of delta_v and no times).
struct MeasuredCurve {
  std::vector<double> time_s;    // [samples], or empty
  std::vector<double> delta_v;   // [samples] m3, or the tidal volume
  std::vector<double> sigma_m3;  // [samples] deviation of independent samples; empty: the same for all

  bool is_tidal_volume() const noexcept { return time_s.empty() && delta_v.size() == 1; }
  double tidal_volume() const;  // m3; the highest value
};

/// The loss of a residual. Robust losses grow more slowly than the square beyond a few deviations: Huber's
/// linearly beyond 1.345 (Huber 1964), Student's logarithmically, with 4 degrees of freedom (Lange et al.
/// 1989).
enum class Loss { squares, huber, student };

/// Returns the deviation by which each residual is divided, [samples] m3: the curve's own sigma if it has
/// one. Otherwise the whole curve counts as 20 independent measurements with a deviation of 1 % of the tidal
/// volume (our choice; it matters only beside priors).
Eigen::VectorXd sample_deviation(const MeasuredCurve& measured);

/// Returns residuals whose squares are the loss of `residuals` [samples], which are in deviations. `scale` is
/// the deviation, in the same unit, of residuals that are no outliers.
Eigen::VectorXd robust_residuals(const Eigen::VectorXd& residuals, Loss loss, double scale);

/// Returns the derivative of each robust residual with respect to its residual.
Eigen::VectorXd robust_slopes(const Eigen::VectorXd& residuals, Loss loss, double scale);

/// Returns a robust deviation: 1.4826 times the median of the absolute values.
double median_deviation(const Eigen::VectorXd& residuals);

/// Returns a simulated curve at the measured times, or its highest value if only that was measured.
Eigen::VectorXd as_measured(const MeasuredCurve& measured, const std::vector<double>& curve, double dt_s);

/// Returns the same for a derivative of the curve. The derivative of the highest value is the derivative at
/// the time of the highest value.
Eigen::VectorXd as_measured(const MeasuredCurve& measured, const std::vector<double>& curve,
                            const std::vector<double>& derivative, double dt_s);

/// Returns a curve that is sampled every dt_s from time 0, interpolated linearly at the given times.
Eigen::VectorXd sampled(const std::vector<double>& curve, double dt_s, const std::vector<double>& time_s);

}  // namespace trunk
