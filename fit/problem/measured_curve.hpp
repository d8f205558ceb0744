#pragma once

#include <Eigen/Core>
#include <vector>

namespace trunk {

/// What the model should do: a volume curve at increasing times from 0, or its highest value alone, whenever
/// that comes (one entry of delta_v and no times).
struct MeasuredCurve {
  std::vector<double> time_s;    // [samples], or empty
  std::vector<double> delta_v;   // [samples] m3, or the tidal volume
  std::vector<double> sigma_m3;  // [samples] of independent samples; empty: all count alike

  bool is_tidal_volume() const noexcept { return time_s.empty() && delta_v.size() == 1; }
  double tidal_volume() const;  // m3, the highest value
};

/// How residuals are charged. The robust ones charge those beyond a few deviations less than their square:
/// Huber's linearly beyond 1.345 (Huber 1964), Student's with 4 degrees of freedom logarithmically (Lange et
/// al. 1989).
enum class Loss { squares, huber, student };

/// Deviation with which each sample enters the sum of squares, m3. That of the measured where it gives one;
/// else as if a whole curve were 20 independent measurements of 1 % of the tidal volume each, which matters
/// only for the balance with what is known beforehand (our choice).
Eigen::VectorXd sample_deviation(const MeasuredCurve& measured);

/// Residuals in deviations => residuals whose square is the loss. `scale` is the deviation, in those units,
/// of residuals that are no outliers.
Eigen::VectorXd robust_residuals(const Eigen::VectorXd& residuals, Loss loss, double scale);

/// How the charged residuals grow with the residuals.
Eigen::VectorXd robust_slopes(const Eigen::VectorXd& residuals, Loss loss, double scale);

/// A robust deviation: 1.4826 times the median of the absolute values.
double median_deviation(const Eigen::VectorXd& residuals);

/// What a simulated curve shows of what the measured names: its samples, or its highest value.
Eigen::VectorXd as_measured(const MeasuredCurve& measured, const std::vector<double>& curve, double dt_s);

/// The same of the curve's derivative: where the curve is highest, the derivative is that of the highest
/// value.
Eigen::VectorXd as_measured(const MeasuredCurve& measured, const std::vector<double>& curve,
                            const std::vector<double>& derivative, double dt_s);

/// A curve sampled every dt_s from time 0, read off at the measured times, straight between its samples.
Eigen::VectorXd sampled(const std::vector<double>& curve, double dt_s, const std::vector<double>& time_s);

}  // namespace trunk
