#pragma once

#include <vector>

#include "dynamics/simulate.hpp"
#include "dynamics/trial.hpp"

namespace trunk {

/// Lung volume above its start at every step, m3: what a fit compares.
struct VolumeCurve {
  Summary summary;
  std::vector<double> delta_v;  // [steps + 1]; fewer where the simulation ended early
};

/// A lung of no volume has turned inside out: whatever comes of it is no breath.
void require_lung(double lowest_volume, Summary& summary);

/// The volume curves of trials, side by side in the lanes of S. trials: [1 to lanes_of<S>], as are curves.
template <Scalar S>
void calc_volume_curves(const Model& model, std::span<const Trial<double>> trials, const TimeGrid& grid,
                        std::span<VolumeCurve> curves) {
  const double start_volume = enclosed_volume<double>(model.lung, model.rest);
  std::vector<S> delta_v;  // [steps + 1]
  delta_v.reserve(static_cast<std::size_t>(grid.steps()) + 1);
  const Trial<S> trial = in_lanes<S>(trials);
  const Summaries<S> summaries =
      simulate_lanes(model, trial.parameters, trial.activation, grid,
                     [&](int, const S&, const State<S>& state, const StepReport<S>&) {
                       delta_v.push_back(enclosed_volume<S>(model.lung, state.position) - S(start_volume));
                     });
  for (std::size_t i = 0; i < trials.size(); ++i) {
    auto& [summary, curve] = curves[i];
    summary = summaries[i];
    const auto seen = static_cast<std::size_t>(summary.steps) + (summary.completed() ? 1 : 0);
    curve.clear();
    for (std::size_t n = 0; n < seen; ++n) curve.push_back(in_lane(delta_v[n], static_cast<int>(i)));
    require_lung(start_volume + *std::min_element(curve.begin(), curve.end()), summary);
  }
}

}  // namespace trunk
