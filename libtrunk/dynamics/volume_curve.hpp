#pragma once

#include <vector>

#include "dynamics/simulate.hpp"
#include "dynamics/trial.hpp"

namespace trunk {

/// The lung volume above its start at every step, m3. A fit compares it with the measured one.
struct VolumeCurve {
  Ending ending;
  std::vector<double> delta_v;  // [steps + 1]; fewer where the simulation ended early
};

/// Sets the ending to diverged if the lung volume fell to 0 or below: the lung has then turned inside out,
/// and the result is not a breath.
void require_lung(double lowest_volume, Ending& ending);
void require_lung(double start_volume, VolumeCurve& curve);

/// The lung volume above its start, m3. Triangles that never move add a constant and are left out.
class LungGain {
 public:
  explicit LungGain(const Model& model);

  /// Returns the volume above the start. position: [particles] m
  template <Scalar S>
  S of(std::span<const Vec3<S>> position) const noexcept {
    return volume_of_fans<S>(moving_, position) - S(start_);
  }

 private:
  RingTable moving_;  // fans
  double start_;      // m3, the volume of these triangles with the origin, at rest
};

/// Simulates a trial and returns how each lane ended. => delta_v, the lung volume above its start at every
/// step that was reached, m3
template <Scalar S>
Endings<S> simulate_volume(const Model& model, const Trial<S>& trial, const TimeGrid& grid,
                           std::vector<S>& delta_v) {
  const LungGain gain(model);
  delta_v.reserve(static_cast<std::size_t>(grid.steps()) + 1);
  return simulate_lanes(model, trial.parameters, trial.activation, grid,
                        [&](int, const S&, const State<S>& state, const StepReport<S>&) {
                          delta_v.push_back(gain.of<S>(state.position));
                        });
}

/// Returns the curve of one lane until it ended.
template <Scalar S>
VolumeCurve curve_in_lane(const Model& model, std::span<const S> delta_v, Ending ending, int lane) {
  const std::size_t seen = static_cast<std::size_t>(ending.steps) + (ending.completed() ? 1 : 0);
  VolumeCurve curve{std::move(ending), {}};
  curve.delta_v.reserve(seen);
  for (const S& v : delta_v.first(seen)) curve.delta_v.push_back(in_lane(v, lane));
  require_lung(enclosed_volume<double>(model.lung, model.rest), curve);
  return curve;
}

/// Calculates the volume curves of trials, side by side in the lanes of S.
/// trials, curves: [1 to lanes_of<S>].
template <Scalar S>
void calc_volume_curves(const Model& model, std::span<const Trial<double>> trials, const TimeGrid& grid,
                        std::span<VolumeCurve> curves) {
  std::vector<S> delta_v;
  const Endings<S> endings = simulate_volume(model, in_lanes<S>(trials), grid, delta_v);
  for (std::size_t i = 0; i < trials.size(); ++i)
    curves[i] = curve_in_lane<S>(model, delta_v, endings[i], static_cast<int>(i));
}

/// Calculates the volume curve of a trial and its derivatives along directions.
/// directions, derivatives: [0 to N].
template <int N>
void calc_volume_derivatives(const Model& model, const Trial<double>& trial,
                             std::span<const Trial<double>> directions, const TimeGrid& grid,
                             VolumeCurve& curve, std::span<std::vector<double>> derivatives) {
  std::vector<Dual<N>> delta_v;
  const auto endings = simulate_volume(model, with_tangents<N>(trial, directions), grid, delta_v);
  curve = curve_in_lane<Dual<N>>(model, delta_v, endings[0], 0);
  for (std::size_t i = 0; i < directions.size(); ++i) {
    derivatives[i].clear();
    for (const Dual<N>& v : std::span(delta_v).first(curve.delta_v.size()))
      derivatives[i].push_back(in_lane(v.tangent, static_cast<int>(i)));
  }
}

}  // namespace trunk
