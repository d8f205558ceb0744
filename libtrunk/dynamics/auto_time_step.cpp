#include "dynamics/auto_time_step.hpp"

#include <limits>
#include <optional>

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

/// The grid ends where the breath does, to less than a step of 1 ms.
bool divides(double dt_s, double duration_s) {
  return std::abs(dt_s * std::round(duration_s / dt_s) - duration_s) < 0.5e-3;
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
                              const BreathActivation<double>& activation, double duration_s) {
  constexpr double safety = 0.92;
  const Trial<double> trial{parameters, activation};
  TimeStepChoice choice{{fine_s, duration_s}, stable_time_step(model, parameters), 0.0};
  const auto fine = run(model, trial, choice.grid);
  if (!fine) return choice;
  for (const double ms : {6.0, 5.5, 5.0, 4.5, 4.0, 3.5, 3.0, 2.5, 2.0, 1.5})
    for (const Damping damping : {Damping::centred, Damping::implicit}) {
      const TimeGrid grid{1e-3 * ms, duration_s, damping};
      const double stable_s = stable_time_step(model, parameters, damping);
      if (grid.dt_s > safety * stable_s || !divides(grid.dt_s, duration_s)) continue;
      const auto error = estimated_error(model, trial, grid, *fine);
      if (error && *error <= auto_time_step_tolerance) return {grid, stable_s, *error};
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
