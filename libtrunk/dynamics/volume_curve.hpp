#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "dynamics/simulate.hpp"
#include "dynamics/trial.hpp"

namespace trunk {

/// What can be observed of a breath: curves with a sample at each step and one at the start, or fewer where
/// the run ended early. All are changes from t = 0 (end-expiration). A fit compares them with measured ones.
struct BreathCurves {
  std::vector<double> delta_v;       // m3, lung volume
  std::vector<double> abdominal_Pa;  // inside the held volume
  std::vector<double> pleural_Pa;    // 0 without a lung
  std::vector<double> right_dome_m;  // height of the top of a dome
  std::vector<double> left_dome_m;
};

/// The curves in the order of observed values. Each kernel has its own copy, so the linkage is internal.
constexpr std::array all_curves = {&BreathCurves::delta_v, &BreathCurves::abdominal_Pa,
                                   &BreathCurves::pleural_Pa, &BreathCurves::right_dome_m,
                                   &BreathCurves::left_dome_m};

/// The curves of a simulated breath, and how it ended.
struct VolumeCurve : BreathCurves {
  Ending ending;
  double above_relaxation = 0.0;  // m3, the volume at t = 0 (end-expiration) above rest; 0 from rest
};

/// Subtracts the first of some values from all, and returns it; 0 if there are none.
double take_first_off(std::vector<double>& values);

/// Sets the ending to diverged if the lung volume fell to 0 or below: the lung has then turned inside out,
/// and the result is not a breath.
void require_lung(double lowest_volume, Ending& ending);

/// What is observed at one step, above its value at rest, in the order of all_curves.
template <Scalar S>
using Observed = std::array<S, all_curves.size()>;

/// Returns how far the top of a dome is above its place at rest, m.
template <Scalar S>
S dome_rise(const std::vector<int>& top, const Model& model, const State<S>& state) noexcept {
  S sum(0.0);
  for (const int i : top) {
    const auto at = static_cast<std::size_t>(i);
    sum = sum + (state.position[at].z() - S(model.rest[at].z()));
  }
  return S(1.0 / std::max(1.0, static_cast<double>(top.size()))) * sum;
}

/// Simulates a trial and returns how each lane ended. => observed, at every step that was reached
template <Scalar S>
Endings<S> simulate_observed(const Model& model, const Trial<S>& trial, const TimeGrid& grid,
                             std::vector<Observed<S>>& observed) {
  observed.reserve(static_cast<std::size_t>(grid.steps()) + 1);
  return simulate_lanes(model, trial.parameters, trial.activation, grid,
                        [&](int, const S&, const State<S>& state, const StepReport<S>& report) {
                          observed.push_back({state.lung_gain, report.pressure_Pa, report.pleural_pressure_Pa,
                                              dome_rise(model.domes.right, model, state),
                                              dome_rise(model.domes.left, model, state)});
                        });
}

/// Returns the number of samples of a simulation that ended like that.
inline std::size_t samples_until(const Ending& ending) noexcept {
  return static_cast<std::size_t>(ending.steps) + (ending.completed() ? 1 : 0);
}

/// Returns the curves of one lane until it ended. observed: above rest
template <Scalar S>
VolumeCurve curve_in_lane(const Model& model, std::span<const Observed<S>> observed, const Ending& ending,
                          int lane) {
  VolumeCurve curve;
  curve.ending = ending;
  for (std::size_t k = 0; k < all_curves.size(); ++k) {
    std::vector<double>& values = curve.*all_curves[k];
    values.reserve(samples_until(ending));
    for (const Observed<S>& o : observed.first(samples_until(ending))) values.push_back(in_lane(o[k], lane));
  }
  if (curve.ending.completed())
    require_lung(enclosed_volume<double>(model.lung, model.rest) +
                     *std::min_element(curve.delta_v.begin(), curve.delta_v.end()),
                 curve.ending);
  curve.above_relaxation = take_first_off(curve.delta_v);
  for (std::size_t k = 1; k < all_curves.size(); ++k) take_first_off(curve.*all_curves[k]);
  return curve;
}

/// Calculates the curves of trials, side by side in the lanes of S.
/// trials, curves: [1 to lanes_of<S>].
template <Scalar S>
void calc_volume_curves(const Model& model, std::span<const Trial<double>> trials, const TimeGrid& grid,
                        std::span<VolumeCurve> curves) {
  std::vector<Observed<S>> observed;
  const Endings<S> endings = simulate_observed(model, in_lanes<S>(trials), grid, observed);
  for (std::size_t i = 0; i < trials.size(); ++i)
    curves[i] = curve_in_lane<S>(model, observed, endings[i], static_cast<int>(i));
}

/// Calculates the curves of a trial, and the derivatives of what is observed, above rest, along directions.
/// directions, derivatives: [0 to N].
template <int N>
void calc_volume_derivatives(const Model& model, const Trial<double>& trial,
                             std::span<const Trial<double>> directions, const TimeGrid& grid,
                             VolumeCurve& curve, std::span<BreathCurves> derivatives) {
  std::vector<Observed<Dual<N>>> observed;
  const auto endings = simulate_observed(model, with_tangents<N>(trial, directions), grid, observed);
  curve = curve_in_lane<Dual<N>>(model, observed, endings[0], 0);
  for (std::size_t i = 0; i < directions.size(); ++i)
    for (std::size_t k = 0; k < all_curves.size(); ++k) {
      std::vector<double>& along = derivatives[i].*all_curves[k];
      along.clear();
      for (const Observed<Dual<N>>& o : std::span(observed).first(curve.delta_v.size()))
        along.push_back(in_lane(o[k].tangent, static_cast<int>(i)));
    }
}

}  // namespace trunk
