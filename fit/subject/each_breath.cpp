#include "subject/each_breath.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "breaths/knot_line.hpp"
#include "dynamics/breath_chain.hpp"
#include "uncertainty/noise.hpp"

namespace trunk {
namespace {

constexpr Eigen::Index samples = 120;  // of a breath
constexpr double near_enough = 0.02;   // change of k_muscle that needs no further attempt
constexpr double not_fitted = std::numeric_limits<double>::quiet_NaN();

/// Takes off the line between both ends.
void level(Eigen::VectorXd& volume) {
  const Eigen::Index last = volume.size() - 1;
  volume -= Eigen::VectorXd::LinSpaced(volume.size(), volume[0], volume[last]);
}

/// The chain of breaths, and what is fitted to each.
class ChainFit {
 public:
  ChainFit(const SubjectFit& fit, const Estimation& e, const Segmentation& segmentation)
      : fit_(fit),
        usual_(e.best),
        mean_(*fit.measurement().breath),
        segmentation_(segmentation),
        chain_(fit.trunk().model, fit.file().scenario.time.dt_s, fit.file().scenario.time.damping) {}

  /// Fits one breath and goes on behind it.
  BreathRefit operator()(std::size_t k) {
    const auto start = std::chrono::steady_clock::now();
    const Breath& breath = segmentation_.breaths[k];
    BreathRefit row;
    row.number = breath.number;
    row.onset_s = breath.onset_s;
    row.tidal_volume_m3 = breath.tidal_volume_m3;
    row.muscle = {"k_muscle", "N/m", not_fitted, not_fitted, not_fitted, not_fitted};
    row.nrmse = not_fitted;
    row.status = "failed";
    try {
      if (!begun_) begin(breath);
      follow(breath, row);
    } catch (const std::exception& error) {
      row.error = error.what();
    }
    begun_ = row.error.empty();
    row.latency_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return row;
  }

 private:
  /// How long before its volume starts a breath may begin to pull.
  double early_s() const { return 2.0 * std::max(-usual_.activation.onset_s, 0.0); }

  void begin(const Breath& breath) {
    const Ending ending = chain_.begin_repeating(usual_, mean_.duration_s, breath.onset_s,
                                                 breath.onset_s - early_s() - chain_step_s());
    if (!ending.completed()) throw std::runtime_error(ending.message);
  }

  double chain_step_s() const { return fit_.file().scenario.time.dt_s; }

  Trial<double> trial(const Breath& breath, double muscle) const {
    Trial<double> t = usual_;
    t.parameters.muscle = muscle;
    if (fit_.plan().timing == Timing::scenario) return t;
    const double in = breath.inspiration_s() / mean_.inspiration_s,
                 out = breath.expiration_s() / (mean_.duration_s - mean_.inspiration_s);
    t.activation.onset_s *= std::min(in, 2.0);
    t.activation.rise_s *= in;
    t.activation.fast_fall_s *= out;
    t.activation.slow_fall_s *= out;
    return t;
  }

  double keep_s(const Breath& breath) const {
    return std::max(breath.end_s - early_s() - chain_step_s(), 0.5 * (breath.peak_s + breath.end_s));
  }

  /// Returns the volume of an attempt between onset and the moment kept, level at both ends.
  Eigen::VectorXd attempt(const Breath& breath, double muscle) {
    const double keep = keep_s(breath);
    const auto curve = chain_.attempt(trial(breath, muscle), breath.onset_s, keep, keep);
    if (!curve.ending.completed()) throw std::runtime_error(curve.ending.message);
    std::vector<double> times;
    for (Eigen::Index i = 0; i < samples; ++i) times.push_back(time_s(breath, i) - curve.first_s);
    Eigen::VectorXd volume = sampled(curve.volume, curve.dt_s, times);
    level(volume);
    return volume;
  }

  double time_s(const Breath& breath, Eigen::Index i) const {
    return breath.onset_s +
           (keep_s(breath) - breath.onset_s) * static_cast<double>(i) / static_cast<double>(samples - 1);
  }

  Eigen::VectorXd measured(const Breath& breath) const {
    Eigen::VectorXd volume(samples);
    for (Eigen::Index i = 0; i < samples; ++i)
      volume[i] = interpolated(segmentation_.time_s, segmentation_.volume_m3, time_s(breath, i));
    level(volume);
    return volume;
  }

  /// The volume is almost linear in k_muscle, so a secant through two attempts ends the search.
  void follow(const Breath& breath, BreathRefit& row) {
    const Eigen::VectorXd wanted = measured(breath);
    double muscle = usual_.parameters.muscle * breath.tidal_volume_m3 / mean_.tidal_volume_m3;
    Eigen::VectorXd model = attempt(breath, muscle), slope = model / muscle;
    row.evaluations = 1;
    constexpr std::size_t most_attempts = 5;
    double step = slope.dot(wanted - model) / slope.squaredNorm();
    while (std::abs(step) > near_enough * muscle && row.evaluations < most_attempts) {
      const double next = std::max(muscle + step, 0.01 * muscle);
      const Eigen::VectorXd there = attempt(breath, next);
      ++row.evaluations;
      slope = (there - model) / (next - muscle);
      muscle = next;
      model = there;
      step = slope.dot(wanted - model) / slope.squaredNorm();
    }
    chain_.accept();
    conclude(muscle + step, slope, wanted - model - step * slope, row);
    row.nrmse =
        std::sqrt((wanted - model).squaredNorm() / static_cast<double>(samples)) / breath.tidal_volume_m3;
    row.status = "converged";
  }

  static void conclude(double muscle, const Eigen::VectorXd& slope, const Eigen::VectorXd& residuals,
                       BreathRefit& row) {
    const Eigen::MatrixXd rows = slope;
    const Noise noise = estimate_noise(residuals, rows);
    const auto deviation = [&](double noise_deviation, double rho) {
      return std::sqrt(least_squares_covariance(rows, noise_covariance(samples, noise_deviation, rho))(0, 0));
    };
    const double t = t_quantile(noise.freedom), corrected = deviation(noise.deviation, noise.rho),
                 naive = deviation(noise.white_deviation, 0.0);
    row.muscle.value = muscle;
    row.muscle.stderr_ = corrected;
    row.muscle.lower95 = muscle - t * corrected;
    row.muscle.upper95 = muscle + t * corrected;
    row.muscle.naive95 = {muscle - t * naive, muscle + t * naive};
    row.muscle.identifiable = true;
  }

  const SubjectFit& fit_;
  const Candidate usual_;
  const MeasuredBreath& mean_;
  const Segmentation& segmentation_;
  BreathChain chain_;
  bool begun_ = false;
};

}  // namespace

std::vector<BreathRefit> refit_each_breath(const SubjectFit& fit, const Estimation& e,
                                           const Segmentation& segmentation,
                                           const std::function<void(std::size_t)>& report) {
  ChainFit chain(fit, e, segmentation);
  const auto& cancelled = fit.plan().estimation.execution.cancelled;
  std::vector<BreathRefit> rows;
  for (std::size_t k = 0; k < segmentation.breaths.size(); ++k) {
    if (cancelled && cancelled()) throw Cancelled();
    BreathRefit row = chain(k);
    if (!segmentation.breaths[k].kept) continue;
    rows.push_back(std::move(row));
    if (report) report(rows.size());
  }
  return rows;
}

}  // namespace trunk
