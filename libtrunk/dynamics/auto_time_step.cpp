#include "dynamics/auto_time_step.hpp"

#include <cmath>
#include <limits>
#include <optional>

#include "dynamics/stability.hpp"
#include "dynamics/volume_curve.hpp"

namespace trunk {
namespace {

/// A curve of the lung volume above rest, and its step.
struct Sampled {
  double dt_s;
  std::vector<double> gains;

  double operator()(double time_s) const noexcept {  // straight between samples
    const double place = time_s / dt_s;
    const std::size_t before = std::min(static_cast<std::size_t>(place), gains.size() - 2);
    const double share = place - static_cast<double>(before);
    return gains[before] + share * (gains[before + 1] - gains[before]);
  }
};

std::optional<Sampled> run(const Model& model, const Trial<double>& trial, const TimeGrid& grid) {
  VolumeCurve curve;
  kernel().volume_curve(model, {&trial, 1}, grid, {&curve, 1});
  if (!curve.ending.completed() || curve.delta_v.size() < 2) return std::nullopt;
  for (double& v : curve.delta_v) v += curve.above_relaxation;
  return Sampled{grid.dt_s, std::move(curve.delta_v)};
}

/// Returns the largest difference at the samples of the coarse curve, over the largest change of the fine
/// one.
double difference(const Sampled& coarse, const Sampled& fine) {
  double apart = 0.0, largest = 0.0;
  for (double v : fine.gains) largest = std::max(largest, std::abs(v - fine.gains.front()));
  const double end_s = fine.dt_s * static_cast<double>(fine.gains.size() - 1);
  for (std::size_t n = 0; n < coarse.gains.size(); ++n) {
    const double time_s = coarse.dt_s * static_cast<double>(n);
    if (time_s <= end_s) apart = std::max(apart, std::abs(coarse.gains[n] - fine(time_s)));
  }
  return largest > 0.0 ? apart / largest : 0.0;
}

/// Returns the grid of fewest equal steps that make up the breath and are not longer than `at_most_s`.
TimeGrid grid_of(double at_most_s, const TimeGrid& breath, Damping damping) {
  const double duration_s = breath.duration_s;
  return {duration_s / std::ceil(duration_s / at_most_s), duration_s, damping, breath.start};
}

/// The spectral bounds on the step for both kinds of damping.
struct Bounds {
  double centred_s, implicit_s;

  double of(Damping damping) const noexcept { return damping == Damping::centred ? centred_s : implicit_s; }
  double longest() const noexcept { return std::max(centred_s, implicit_s); }
};

Bounds bounds_of(const Model& model, Parameters<double> parameters, double stiffer) {
  parameters.elasticity *= stiffer;
  parameters.muscle *= stiffer;
  return {stable_time_step(model, parameters, Damping::centred),
          stable_time_step(model, parameters, Damping::implicit)};
}

/// Returns the short step to compare with: 1 ms, or a quarter of the bound if that is less.
double short_step(const Bounds& bounds) {
  return std::min(1e-3, 0.25 * bounds.longest());
}

/// Returns the grid to compare with. Damping is centred, which is of second order, if that is calm (see
/// Damping).
TimeGrid reference_grid(const Model& model, const Parameters<double>& parameters, double dt_s,
                        const TimeGrid& breath) {
  double rate = 0.0;
  for (std::size_t i = 0; i < model.particles(); ++i)
    rate = std::max(rate, parameters.damping * model.damping_weight[i] / model.mass[i]);
  return grid_of(dt_s, breath, dt_s * rate < 1.0 ? Damping::centred : Damping::implicit);
}

/// Returns the error e h, with e from |V_h - V_r| = e (h - r); nothing if the simulation fails.
std::optional<double> estimated_error(const Model& model, const Trial<double>& trial, const TimeGrid& grid,
                                      const Sampled& fine) {
  const auto coarse = run(model, trial, grid);
  if (!coarse) return std::nullopt;
  return difference(*coarse, fine) * grid.dt_s / (grid.dt_s - fine.dt_s);
}

constexpr double safety = 0.95, longest_s = 8e-3;

/// Returns the longest step within the tolerance that is well above the step of `fine`; nothing if there is
/// none. The search begins at `part` of the bounds. A bound above the longest step, or infinity, counts as
/// the longest step.
std::optional<TimeStepChoice> longest_that_serves(const Model& model, const Trial<double>& trial,
                                                  const TimeGrid& breath, const Bounds& bounds,
                                                  const Sampled& fine, double& part) {
  constexpr double shorter = 0.85;
  const auto step_s = [&](double bound_s) { return part * std::min(bound_s, longest_s / safety); };
  for (; step_s(bounds.longest()) > 1.5 * fine.dt_s; part *= shorter)
    for (const Damping damping : {Damping::centred, Damping::implicit}) {
      const TimeGrid grid = grid_of(step_s(bounds.of(damping)), breath, damping);
      if (grid.dt_s < 1.5 * fine.dt_s) continue;
      const auto error = estimated_error(model, trial, grid, fine);
      if (error && *error <= auto_time_step_tolerance)
        return TimeStepChoice{grid, bounds.of(damping), *error};
    }
  return std::nullopt;
}

}  // namespace

TimeStepChoice auto_time_step(const Model& model, const Parameters<double>& parameters,
                              const BreathActivation<double>& activation, const TimeGrid& breath,
                              double stiffer) {
  constexpr int most_halvings = 3;
  const Trial<double> trial{parameters, activation};
  const Bounds bounds = bounds_of(model, parameters, stiffer);
  double part = safety, reference_s = short_step(bounds);
  TimeStepChoice last{{}, 0.0, std::numeric_limits<double>::infinity()};
  std::optional<Sampled> before;
  for (int halvings = 0; halvings <= most_halvings; ++halvings, reference_s /= 2.0) {
    last.grid = reference_grid(model, parameters, reference_s, breath);
    last.stable_s = bounds.of(last.grid.damping);
    const auto fine = run(model, trial, last.grid);
    if (!fine) continue;
    if (const auto choice = longest_that_serves(model, trial, breath, bounds, *fine, part)) return *choice;
    if (before) last.estimated_error = difference(*before, *fine);
    before = fine;
  }
  return last;
}

double time_step_error(const Model& model, const Parameters<double>& parameters,
                       const BreathActivation<double>& activation, const TimeGrid& grid) {
  const Trial<double> trial{parameters, activation};
  const double short_s = std::min(short_step(bounds_of(model, parameters, 1.0)), 0.5 * grid.dt_s);
  const auto fine = run(model, trial, reference_grid(model, parameters, short_s, grid));
  const auto error = fine ? estimated_error(model, trial, grid, *fine) : std::nullopt;
  return error.value_or(std::numeric_limits<double>::infinity());
}

}  // namespace trunk
