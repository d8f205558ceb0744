#pragma once

#include <vector>

#include "dynamics/simulate.hpp"
#include "dynamics/trial.hpp"

namespace trunk {

/// The lung volume of a breath at every step, m3. A fit compares it with the measured one.
struct VolumeCurve {
  Ending ending;
  std::vector<double> delta_v;    // [steps + 1] above its value at t = 0; fewer where the run ended early
  double above_relaxation = 0.0;  // the volume at t = 0 (end-expiration) above rest; 0 from rest
};

/// Subtracts the first of some values from all, and returns it; 0 if there are none.
double take_first_off(std::vector<double>& values);

/// Sets the ending to diverged if the lung volume fell to 0 or below: the lung has then turned inside out,
/// and the result is not a breath.
void require_lung(double lowest_volume, Ending& ending);

/// Simulates a trial and returns how each lane ended. => gains, the lung volume above rest at every step that
/// was reached, m3
template <Scalar S>
Endings<S> simulate_volume(const Model& model, const Trial<S>& trial, const TimeGrid& grid,
                           std::vector<S>& gains) {
  gains.reserve(static_cast<std::size_t>(grid.steps()) + 1);
  return simulate_lanes(
      model, trial.parameters, trial.activation, grid,
      [&](int, const S&, const State<S>& state, const StepReport<S>&) { gains.push_back(state.lung_gain); });
}

/// Returns the number of samples of a simulation that ended like that.
inline std::size_t samples_until(const Ending& ending) noexcept {
  return static_cast<std::size_t>(ending.steps) + (ending.completed() ? 1 : 0);
}

/// Returns the curve of one lane until it ended. gains: above rest
template <Scalar S>
VolumeCurve curve_in_lane(const Model& model, std::span<const S> gains, const Ending& ending, int lane) {
  VolumeCurve curve{ending, {}};
  curve.delta_v.reserve(samples_until(ending));
  for (const S& v : gains.first(samples_until(ending))) curve.delta_v.push_back(in_lane(v, lane));
  if (curve.ending.completed())
    require_lung(enclosed_volume<double>(model.lung, model.rest) +
                     *std::min_element(curve.delta_v.begin(), curve.delta_v.end()),
                 curve.ending);
  curve.above_relaxation = take_first_off(curve.delta_v);
  return curve;
}

/// Calculates the volume curves of trials, side by side in the lanes of S.
/// trials, curves: [1 to lanes_of<S>].
template <Scalar S>
void calc_volume_curves(const Model& model, std::span<const Trial<double>> trials, const TimeGrid& grid,
                        std::span<VolumeCurve> curves) {
  std::vector<S> gains;
  const Endings<S> endings = simulate_volume(model, in_lanes<S>(trials), grid, gains);
  for (std::size_t i = 0; i < trials.size(); ++i)
    curves[i] = curve_in_lane<S>(model, gains, endings[i], static_cast<int>(i));
}

/// Calculates the volume curve of a trial, and the derivatives of the volume above rest along directions.
/// directions, derivatives: [0 to N].
template <int N>
void calc_volume_derivatives(const Model& model, const Trial<double>& trial,
                             std::span<const Trial<double>> directions, const TimeGrid& grid,
                             VolumeCurve& curve, std::span<std::vector<double>> derivatives) {
  std::vector<Dual<N>> gains;
  const auto endings = simulate_volume(model, with_tangents<N>(trial, directions), grid, gains);
  curve = curve_in_lane<Dual<N>>(model, gains, endings[0], 0);
  for (std::size_t i = 0; i < directions.size(); ++i) {
    derivatives[i].clear();
    for (const Dual<N>& v : std::span(gains).first(curve.delta_v.size()))
      derivatives[i].push_back(in_lane(v.tangent, static_cast<int>(i)));
  }
}

}  // namespace trunk
