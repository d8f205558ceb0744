#pragma once

#include <Eigen/Core>
#include <vector>

#include "dynamics/simulate.hpp"
#include "dynamics/volume_curve.hpp"
#include "traces/channel.hpp"

namespace trunk {

/// What was measured beside the volume, as changes from end-expiration.
struct MeasuredObservable {
  ChannelKind kind = ChannelKind::gastric;
  /// [samples] Pa, m or the unit of an EMG, at the times of the volume; or the one excursion of the right
  /// dome (which ultrasound sees through the liver) at the highest volume, m.
  std::vector<double> value;
  double deviation = 0.0;  // of an independent sample at first; see Objective::reweigh

  bool is_number() const noexcept { return value.size() == 1; }
  /// Returns whether it is a pressure, which gives forces a scale.
  bool is_pressure() const noexcept {
    return kind == ChannelKind::gastric || kind == ChannelKind::pleural ||
           kind == ChannelKind::transdiaphragmatic;
  }
};

/// What the model is fitted to: a volume curve at increasing times from 0, and what was measured beside it;
/// or only the highest volume, at whatever time (one entry of delta_v and no times).
struct MeasuredCurve {
  std::vector<double> time_s;    // [samples], or empty
  std::vector<double> delta_v;   // [samples] m3, or the tidal volume
  std::vector<double> sigma_m3;  // [samples] deviation of independent samples; empty: the same for all
  std::vector<MeasuredObservable> beside = {};

  bool is_tidal_volume() const noexcept { return time_s.empty() && delta_v.size() == 1; }
  double tidal_volume() const;  // m3; the highest value
};

/// The part of a list of all measured values that belongs to one observable.
struct Block {
  Eigen::Index first, count;
};

/// Returns the blocks of all measured values, one after the other: the volume, then what is beside it.
std::vector<Block> blocks_of(const MeasuredCurve& measured);

/// Returns values as a vector.
Eigen::VectorXd mapped(const std::vector<double>& values);

/// Returns all measured values, one block after the other.
Eigen::VectorXd values_of(const MeasuredCurve& measured);

/// Returns what an observable may have beside what the model says, [values, courses]: an offset for any
/// curve. Beside it, a slow drift for what is measured in the gullet (a straight line). An EMG has a gain and
/// a delay too: it is the EMG itself and its slope that the model's activation may consist of, so that the
/// measured value is 0 there.
Eigen::MatrixXd nuisance_of(const MeasuredCurve& measured, std::size_t block);

/// A model's breath at the measured times, [samples] each; or the derivatives of it.
struct SeenBreath {
  Eigen::VectorXd delta_v, abdominal_Pa, pleural_Pa, right_dome_m, activation;
};

/// Returns simulated curves at the measured times. The activation is left empty.
SeenBreath seen(const MeasuredCurve& measured, const BreathCurves& curves, double dt_s);

/// Returns what is measured of a model's breath, one block after the other. `derivative` is the breath
/// itself, or a derivative of it.
Eigen::VectorXd as_measured(const MeasuredCurve& measured, const SeenBreath& breath,
                            const SeenBreath& derivative);

/// Returns the activation at the measured times.
Eigen::VectorXd activation_at(const MeasuredCurve& measured, const BreathActivation<double>& activation,
                              const TimeGrid& grid);

/// The loss of a residual. Robust losses grow more slowly than the square beyond a few deviations: Huber's
/// linearly beyond 1.345 (Huber 1964), Student's logarithmically, with 4 degrees of freedom (Lange et al.
/// 1989).
enum class Loss { squares, huber, student };

/// Returns the deviation by which each residual is divided, [values]. That of the volume is the curve's own
/// sigma if it has one. Otherwise the whole curve counts as 20 independent measurements with a deviation of 1
/// % of the tidal volume (our choice; it matters only beside priors).
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
