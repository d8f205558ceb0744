#include "structure/coarse_breath.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "dynamics/stability.hpp"

namespace trunk {
namespace {

/// Returns the longest equal steps of the breath that are stable, with room for stiffer parameters, calm (see
/// Damping), and not above 8 ms. Damping is centred, so that the error of a step is of second order (our
/// choice: the change from one trunk to another then has an error of about a hundredth of itself).
TimeGrid coarse_grid(const Trunk& trunk, const Scenario& s) {
  constexpr double longest_s = 8e-3, part_of_bound = 0.6;
  double rate = 0.0;
  for (std::size_t i = 0; i < trunk.model.particles(); ++i)
    rate = std::max(rate, s.parameters.damping * trunk.model.damping_weight[i] / trunk.model.mass[i]);
  const double bound_s = stable_time_step(trunk.model, s.parameters, Damping::centred);
  const double step_s = std::min({longest_s, part_of_bound * bound_s, 0.9 / rate});
  const double duration_s = s.time.duration_s;
  return {duration_s / std::ceil(duration_s / step_s), duration_s, Damping::centred, s.time.start};
}

/// Returns the value at `x` of the polynomial through points (Lagrange).
double interpolated(const std::vector<std::pair<double, double>>& points, double x) {
  double sum = 0.0;
  for (const auto& [xi, yi] : points) {
    double term = yi;
    for (const auto& [xj, yj] : points)
      if (xj != xi) term *= (x - xj) / (xi - xj);
    sum += term;
  }
  return sum;
}

Trunk trunk_with(const std::optional<Recoil>& recoil, Scenario s) {
  s.time.start = Start::rest;  // nothing is measured
  Trunk trunk = make_trunk(s);
  trunk.model.recoil = recoil;
  return trunk;
}

}  // namespace

std::optional<Recoil> recoil_for_choices(const Scenario& s) {
  if (s.time.start == Start::rest) return std::nullopt;
  std::optional<Recoil> recoil = make_trunk(s).model.recoil;
  recoil->memory *= 1.5;
  return recoil;
}

CoarseTrunk::CoarseTrunk(const Scenario& s, const std::optional<Recoil>& recoil)
    : trunk_(trunk_with(recoil, s)), trial_{s.parameters, s.activation}, grid_(coarse_grid(trunk_, s)) {
  require_memory(s, trunk_);
}

BreathSummary CoarseTrunk::breath(double k_muscle) const {
  return breaths({k_muscle}).front();
}

std::vector<BreathSummary> CoarseTrunk::breaths(const std::vector<double>& k_muscle) const {
  std::vector<Trial<double>> trials(k_muscle.size(), trial_);
  for (std::size_t i = 0; i < trials.size(); ++i) trials[i].parameters.muscle = k_muscle[i];
  return summarise_breaths(trunk_, trials, grid_);
}

double muscle_for(const CoarseTrunk& trunk, double tidal_volume_m3, double guess) {
  constexpr int most_tries = 4;
  for (int n = 0; n < most_tries; ++n) {
    const std::vector<double> strengths = {0.75 * guess, guess, 1.25 * guess, 1.6 * guess};
    const std::vector<BreathSummary> breaths = trunk.breaths(strengths);
    std::vector<std::pair<double, double>> points;  // (volume, strength)
    for (std::size_t i = 0; i < breaths.size(); ++i)
      if (breaths[i].ending.completed()) points.emplace_back(breaths[i].measures.delta_v, strengths[i]);
    const bool rises = points.size() > 1 && std::is_sorted(points.begin(), points.end());
    if (!rises) break;
    if (tidal_volume_m3 < points.front().first)
      guess = 0.7 * strengths.front();
    else if (tidal_volume_m3 > points.back().first)
      guess = 1.4 * points.back().second;
    else
      return interpolated(points, tidal_volume_m3);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace trunk
