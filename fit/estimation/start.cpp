#include "estimation/start.hpp"

#include <algorithm>
#include <cmath>

#include "compartment/one_compartment.hpp"

namespace trunk {

MeasuredCurve measured_curve_of(const MeasuredBreath& breath, bool weighted) {
  return {breath.time_s, breath.volume_m3, weighted ? breath.sigma_m3 : std::vector<double>()};
}

void adopt_timing(const MeasuredBreath& breath, Scenario& scenario) {
  auto& a = scenario.activation;
  const auto& volume = breath.volume_m3;
  const auto peak = static_cast<std::size_t>(std::max_element(volume.begin(), volume.end()) - volume.begin());
  const double level = a.fast_fall_level * volume[peak];
  std::size_t fallen = peak;
  while (fallen + 1 < volume.size() && volume[fallen] > level) ++fallen;
  const double shortest_s = 0.02;
  a.onset_s = 0.0;
  a.period_s = 0.0;
  a.rise_s = std::max(shortest_s, breath.time_s[peak]);
  a.fast_fall_s = std::max(shortest_s, breath.time_s[fallen] - breath.time_s[peak]);
  a.slow_fall_s = std::max(shortest_s, breath.duration_s - breath.time_s[fallen]);
  a = timed_by_one_compartment(measured_curve_of(breath), a);
  for (const FreeParameter& p : free_parameters()) {  // a fit must start within its bounds
    if (p.group != FreeParameter::Group::timing) continue;
    Candidate c{scenario.parameters, a};
    p.field(c) = std::clamp(p.field(c), p.lower, p.upper);
    a = c.activation;
  }
}

Eigen::VectorXd start_at_tidal_volume(Objective& objective, const Eigen::VectorXd& start) {
  const SearchSpace& space = objective.space();
  const auto muscle = space.find("k_muscle");
  const double measured = objective.measured_curve().tidal_volume();
  if (!muscle || measured <= 0.0) return start;
  const auto ratio = static_cast<Eigen::Index>(*muscle);
  const double lowest = space.lower()[ratio], highest = space.upper()[ratio];
  Eigen::VectorXd x = start;
  for (int steps = 0; steps < 8; ++steps) {
    const auto curve = objective.model(x);
    const double model =
        curve ? curve->maxCoeff() : 4.0 * measured;  // it failed, so the muscle is far too strong
    if (std::abs(model / measured - 1.0) < 0.02) return x;
    // The volume is about proportional to the ratio.
    x[ratio] = std::clamp(x[ratio] + std::log(measured / std::max(model, 0.02 * measured)), lowest, highest);
  }
  return x;
}

}  // namespace trunk
