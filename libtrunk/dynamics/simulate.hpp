#pragma once

#include <fmt/format.h>

#include <string>

#include "activation/breath_activation.hpp"
#include "dynamics/step.hpp"

namespace trunk {

struct TimeGrid {
  double dt_s = 1e-3;       // our choice; the paper ran about 3000 steps a second
  double duration_s = 4.5;  // one breath of the paper's activation

  int steps() const noexcept { return static_cast<int>(std::lround(duration_s / dt_s)); }
};

/// How a simulation ended. Starts unset, so that a forgotten run cannot look like a good one.
struct Summary {
  enum class Status { unset, completed, diverged, volume_lost };
  Status status = Status::unset;
  int steps = 0;
  double time_s = 0.0;
  std::string message = "not run";

  bool completed() const noexcept { return status == Status::completed; }
};

/// True where every particle is finite and nearer to its rest position than `reach_m`.
template <Scalar S>
bool within_reach(const Model& model, const State<S>& state, double reach_m) noexcept {
  for (std::size_t i = 0; i < model.particles(); ++i) {
    const Vec3<S> moved = state.position[i] - lift<S>(model.rest[i]);
    if (!all(dot(moved, moved) < S(reach_m * reach_m))) return false;
  }
  return true;
}

/// Height of the model at rest, m: a particle that moved farther than this has left the trunk.
double height(const Model& model);

/// Runs from rest over the grid. `observe(step, activation, state, report)` is called at step 0 and after
/// each step. Stops early, with the status and time in the Summary, where the volume cannot be held or a
/// particle moves farther than the trunk is tall.
template <Scalar S, class Observer>
Summary simulate(const Model& model, const Parameters<S>& parameters, const BreathActivation<S>& activation,
                 const TimeGrid& grid, Observer&& observe) {
  constexpr int steps_between_checks = 16;
  State<S> state = rest_state<S>(model);
  Workspace<S> workspace = make_workspace(model, parameters, grid.dt_s);
  const double reach_m = height(model);
  const int steps = grid.steps();

  observe(0, activation(0.0), state, StepReport<S>{S(0.0), S(0.0) < S(1.0)});
  for (int n = 1; n <= steps; ++n) {
    const StepReport<S> report = step(model, parameters, activation(state.time_s), state, workspace);
    state.time_s = n * grid.dt_s;  // no accumulated round-off
    if (!all(report.ok))
      return {Summary::Status::volume_lost, n, state.time_s,
              fmt::format("the abdominal volume could not be held at {:.4f} s: the step is too long or the "
                          "forces too strong",
                          state.time_s)};
    if ((n % steps_between_checks == 0 || n == steps) && !within_reach(model, state, reach_m))
      return {Summary::Status::diverged, n, state.time_s,
              fmt::format("a particle moved farther than the trunk is tall before {:.4f} s: the simulation "
                          "diverged",
                          state.time_s)};
    observe(n, activation(state.time_s), state, report);
  }
  return {Summary::Status::completed, steps, state.time_s, "completed"};
}

}  // namespace trunk
