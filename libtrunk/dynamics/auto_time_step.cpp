#include "dynamics/auto_time_step.hpp"

#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "dynamics/stability.hpp"
#include "dynamics/volume_curve.hpp"

namespace trunk {
namespace {

/// A curve with its step, empty where the simulation failed.
struct Sampled {
  double dt_s;
  std::vector<double> delta_v;

  double operator()(double time_s) const noexcept {  // straight between samples
    const double place = time_s / dt_s;
    const std::size_t before = std::min(static_cast<std::size_t>(place), delta_v.size() - 2);
    const double share = place - static_cast<double>(before);
    return delta_v[before] + share * (delta_v[before + 1] - delta_v[before]);
  }
};

std::optional<Sampled> run(const Model& model, const Trial<double>& trial, const TimeGrid& grid) {
  VolumeCurve curve;
  kernel().volume_curve(model, {&trial, 1}, grid, {&curve, 1});
  if (!curve.summary.completed() || curve.delta_v.size() < 2) return std::nullopt;
  return Sampled{grid.dt_s, std::move(curve.delta_v)};
}

/// The largest difference at the samples of the coarse curve, over the largest value of the fine one.
double difference(const Sampled& coarse, const Sampled& fine) {
  double apart = 0.0, largest = 0.0;
  for (double v : fine.delta_v) largest = std::max(largest, std::abs(v));
  const double end_s = fine.dt_s * static_cast<double>(fine.delta_v.size() - 1);
  for (std::size_t n = 0; n < coarse.delta_v.size(); ++n) {
    const double time_s = coarse.dt_s * static_cast<double>(n);
    if (time_s <= end_s) apart = std::max(apart, std::abs(coarse.delta_v[n] - fine(time_s)));
  }
  return largest > 0.0 ? apart / largest : 0.0;
}

/// As many whole steps as the breath takes, none longer than asked for.
TimeGrid grid_of(double at_most_s, double duration_s, Damping damping) {
  return {duration_s / std::ceil(duration_s / at_most_s), duration_s, damping};
}

constexpr double fine_s = 1e-3;

/// See auto_time_step; nothing where the simulation fails.
std::optional<double> estimated_error(const Model& model, const Trial<double>& trial, const TimeGrid& grid,
                                      const Sampled& fine) {
  if (grid.dt_s <= fine_s) return 0.0;
  const auto coarse = run(model, trial, grid);
  if (!coarse) return std::nullopt;
  return difference(*coarse, fine) * grid.dt_s / (grid.dt_s - fine_s);
}

}  // namespace

TimeStepChoice auto_time_step(const Model& model, const Parameters<double>& parameters,
                              const BreathActivation<double>& activation, double duration_s, double stiffer) {
  constexpr double safety = 0.95, longest_s = 8e-3, shorter = 0.85;
  const Trial<double> trial{parameters, activation};
  Parameters<double> stiffest = parameters;
  stiffest.elasticity *= stiffer;
  stiffest.muscle *= stiffer;
  TimeStepChoice choice{{fine_s, duration_s}, stable_time_step(model, stiffest), 0.0};
  const auto fine = run(model, trial, choice.grid);
  if (!fine) return choice;
  const auto stable_s = [&](Damping damping) { return stable_time_step(model, stiffest, damping); };
  const std::pair<Damping, double> bounds[] = {{Damping::centred, stable_s(Damping::centred)},
                                               {Damping::implicit, stable_s(Damping::implicit)}};
  for (double part = safety; part * choice.stable_s > 1.5 * fine_s; part *= shorter)
    for (const auto& [damping, bound_s] : bounds) {
      const TimeGrid grid = grid_of(std::min(longest_s, part * bound_s), duration_s, damping);
      if (grid.dt_s <= fine_s) continue;
      const auto error = estimated_error(model, trial, grid, *fine);
      if (error && *error <= auto_time_step_tolerance) return {grid, bound_s, *error};
    }
  return choice;
}

double time_step_error(const Model& model, const Parameters<double>& parameters,
                       const BreathActivation<double>& activation, const TimeGrid& grid) {
  const Trial<double> trial{parameters, activation};
  const auto fine = run(model, trial, {fine_s, grid.duration_s});
  const auto error = fine ? estimated_error(model, trial, grid, *fine) : std::nullopt;
  return error.value_or(std::numeric_limits<double>::infinity());
}

}  // namespace trunk
