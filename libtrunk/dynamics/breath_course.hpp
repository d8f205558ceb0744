#pragma once

#include <limits>

#include "dynamics/swing.hpp"
#include "dynamics/volume_curve.hpp"

namespace trunk {

/// How far the pressures that a lung makes swing over a breath: the changes from t = 0 (end-expiration) that
/// are the largest in size, with their signs. In a breath of the muscle the pleural pressure falls, and the
/// other rises. Each has its own moment.
struct PleuralSwings {
  double pleural_Pa = 0.0, transdiaphragmatic_Pa = 0.0;
};

/// The volume curve of one simulated breath, and what tables need beside it.
struct BreathCourse {
  VolumeCurve curve;
  double peak_pressure_Pa = 0.0;                 // abdominal, above rest
  double gastric_swing_Pa = 0.0;                 // of the abdominal pressure, see PleuralSwings
  PleuralSwings swings;                          // with a pleura
  double right_rise_m = 0.0, left_rise_m = 0.0;  // of the tops of the domes above t = 0, at the most
  double max_relative_volume_error = 0.0;        // of the held volume
  std::vector<Vec3d> at_start;                   // [particles] m, at t = 0
  std::vector<Vec3d> at_highest, at_lowest;      // [particles] m, at the highest and the lowest lung volume
};

/// Observes a simulation, each lane by itself. (state, report) => course
template <Scalar S>
class BreathWatch {
 public:
  BreathWatch(const Model& model, int steps, const WhileSimulated& check) : model_(model), check_(check) {
    gains_.reserve(static_cast<std::size_t>(steps) + 1);
    at_start_.resize(model.particles());
    at_highest_.resize(model.particles());
    at_lowest_.resize(model.particles());
  }

  void operator()(int step, const State<S>& state, const StepReport<S>& report) {
    constexpr int steps_between_checks = 64;
    if (check_ && step % steps_between_checks == 0) check_();
    const S gain = state.lung_gain;
    gains_.push_back(gain);
    if (step == 0) at_start_ = state.position;
    keep_larger(report.pressure_Pa, peak_pressure_Pa_);
    follow(state, report);
    keep_larger(relative_volume_error(state), max_relative_volume_error_);
    keep_where(highest_ < gain, gain, state.position, highest_, at_highest_);
    keep_where(gain < lowest_, gain, state.position, lowest_, at_lowest_);
  }

  /// Returns the course of one lane until it ended.
  BreathCourse course(Ending ending, int lane) const {
    BreathCourse c;
    for (std::size_t n = 0; n < samples_until(ending); ++n)
      c.curve.delta_v.push_back(in_lane(gains_[n], lane));
    c.curve.above_relaxation = take_first_off(c.curve.delta_v);
    c.curve.ending = std::move(ending);
    require_lung(enclosed_volume<double>(model_.lung, model_.rest) + in_lane(lowest_, lane), c.curve.ending);
    c.peak_pressure_Pa = in_lane(peak_pressure_Pa_, lane);
    c.gastric_swing_Pa = in_lane(gastric_.swing(), lane);
    c.swings = {in_lane(pleural_.swing(), lane), in_lane(transdiaphragmatic_.swing(), lane)};
    c.right_rise_m = in_lane(right_.highest - right_.first, lane);
    c.left_rise_m = in_lane(left_.highest - left_.first, lane);
    c.max_relative_volume_error = in_lane(max_relative_volume_error_, lane);
    for (const auto& [lanes, alone] :
         {std::pair{&at_start_, &c.at_start}, {&at_highest_, &c.at_highest}, {&at_lowest_, &c.at_lowest}})
      for (const Vec3<S>& p : *lanes)
        alone->emplace_back(in_lane(p.x(), lane), in_lane(p.y(), lane), in_lane(p.z(), lane));
    return c;
  }

 private:
  static void keep_larger(const S& value, S& most) { most = select(most < value, value, most); }

  static void keep_where(const Mask<S>& better, const S& gain, const std::vector<Vec3<S>>& position, S& best,
                         std::vector<Vec3<S>>& at_best) {
    if (!any(better)) return;
    best = select(better, gain, best);
    for (std::size_t i = 0; i < position.size(); ++i) at_best[i] = select<S>(better, position[i], at_best[i]);
  }

  void follow(const State<S>& state, const StepReport<S>& report) {
    gastric_(report.pressure_Pa);
    if (model_.pleura) {
      pleural_(report.pleural_pressure_Pa);
      transdiaphragmatic_(report.pressure_Pa - report.pleural_pressure_Pa);
    }
    right_(height_of(model_.domes.right, state));
    left_(height_of(model_.domes.left, state));
  }

  static S height_of(const std::vector<int>& top, const State<S>& state) {
    S sum(0.0);
    for (const int i : top) sum = sum + state.position[static_cast<std::size_t>(i)].z();
    return S(1.0 / static_cast<double>(std::max<std::size_t>(1, top.size()))) * sum;
  }

  S relative_volume_error(const State<S>& state) const {
    const HeldVolume& held = model_.abdomen;
    const double fraction = held.target.empty() ? 1.0 : held.target(state.time_s);
    const S error = enclosed_volume<S>(held.triangles, state.position) / S(fraction * held.rest) - S(1.0);
    return select(error < S(0.0), -error, error);
  }

  const Model& model_;
  const WhileSimulated& check_;
  std::vector<S> gains_;  // [steps + 1] m3
  S peak_pressure_Pa_{0.0}, max_relative_volume_error_{0.0};
  S highest_{-std::numeric_limits<double>::infinity()}, lowest_{std::numeric_limits<double>::infinity()};
  Extremes<S> gastric_, pleural_, transdiaphragmatic_, right_, left_;
  std::vector<Vec3<S>> at_start_, at_highest_, at_lowest_;  // [particles]
};

/// Calculates the courses of trials, side by side in the lanes of S. Each has the bits that it has alone.
/// trials, courses: [1 to lanes_of<S>].
template <Scalar S>
void calc_breath_courses(const Model& model, std::span<const Trial<double>> trials, const TimeGrid& grid,
                         const WhileSimulated& check, std::span<BreathCourse> courses) {
  BreathWatch<S> watch(model, grid.steps(), check);
  const Trial<S> trial = in_lanes<S>(trials);
  Endings<S> endings = simulate_lanes(model, trial.parameters, trial.activation, grid,
                                      [&](int step, const S&, const State<S>& state,
                                          const StepReport<S>& report) { watch(step, state, report); });
  for (std::size_t i = 0; i < trials.size(); ++i)
    courses[i] = watch.course(std::move(endings[i]), static_cast<int>(i));
}

}  // namespace trunk
