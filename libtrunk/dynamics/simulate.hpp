#pragma once

#include <algorithm>
#include <array>
#include <string>

#include "activation/breath_activation.hpp"
#include "dynamics/kernel.hpp"

namespace trunk {

/// The steps of a simulation.
struct TimeGrid {
  double dt_s = 1e-3;       // our choice; the paper ran about 3000 steps a second
  double duration_s = 4.5;  // one breath of the paper's activation
  Damping damping = Damping::implicit;

  int steps() const noexcept { return static_cast<int>(std::lround(duration_s / dt_s)); }
};

/// How a simulation ended. The status is unset at first, so that a forgotten run cannot look like a good one.
struct Ending {
  enum class Status { unset, completed, diverged, volume_lost };
  Status status = Status::unset;
  int steps = 0;
  double time_s = 0.0;
  std::string message = "not run";

  bool completed() const noexcept { return status == Status::completed; }
};

/// How the simulation in each lane ended.
template <Scalar S>
using Endings = std::array<Ending, static_cast<std::size_t>(lanes_of<S>)>;

/// Returns the ending of a simulation at a step and time, with its message.
Ending make_ending(Ending::Status status, int step, double time_s);

/// Returns true where every particle is finite and nearer to its rest position than `reach_m`.
template <Scalar S>
Mask<S> within_reach(const Model& model, const State<S>& state, double reach_m) noexcept {
  Mask<S> within = S(0.0) < S(1.0);
  for (std::size_t i = 0; i < model.particles(); ++i) {
    const Vec3<S> moved = state.position[i] - lift<S>(model.rest[i]);
    within = Mask<S>(within & (dot(moved, moved) < S(reach_m * reach_m)));
  }
  return within;
}

/// Returns the height of the model at rest, m. A particle that moved farther than this has left the trunk.
double height(const Model& model);

/// Simulates all lanes from rest over the grid, in lockstep, and returns their endings. It calls
/// `observe(step, activation, state, report)` at step 0 and after each step. A lane ends early if its volume
/// cannot be held or if a particle moves farther than the trunk is tall. Its values then mean nothing and do
/// not affect other lanes. Once all lanes have ended, `observe` is not called any more. `advance` is `step`,
/// compiled here or for another instruction set.
template <Scalar S, class Observer>
Endings<S> simulate_lanes(const Model& model, const Parameters<S>& parameters,
                          const BreathActivation<S>& activation, const TimeGrid& grid, Observer&& observe,
                          Step<S>* advance = &step<S>) {
  constexpr int steps_between_checks = 16;
  State<S> state = rest_state<S>(model);
  Workspace<S> workspace = make_workspace(model, parameters, grid.dt_s, grid.damping);
  Endings<S> endings;
  const double reach_m = height(model);
  const int steps = grid.steps();

  const auto end = [&](Ending::Status status, const Mask<S>& lanes, int n) {
    const Mask<S> ending = Mask<S>(workspace.running & lanes);
    if (!any(ending)) return;
    for (int i = 0; i < lanes_of<S>; ++i)
      if (in_lane(ending, i)) endings[static_cast<std::size_t>(i)] = make_ending(status, n, state.time_s);
    workspace.running = Mask<S>(workspace.running & !ending);
  };

  observe(0, activation(0.0), state, StepReport<S>{S(0.0), workspace.running});
  for (int n = 1; n <= steps; ++n) {
    const StepReport<S> report = advance(model, parameters, activation(state.time_s), state, workspace);
    state.time_s = n * grid.dt_s;  // no accumulated round-off
    end(Ending::Status::volume_lost, !report.ok, n);
    if (n % steps_between_checks == 0 || n == steps)
      end(Ending::Status::diverged, !within_reach(model, state, reach_m), n);
    if (!any(workspace.running)) return endings;
    observe(n, activation(state.time_s), state, report);
  }
  end(Ending::Status::completed, workspace.running, steps);
  return endings;
}

/// Simulates one trial, with the step that is the fastest on this machine, and returns its ending.
template <Scalar S, class Observer>
Ending simulate(const Model& model, const Parameters<S>& parameters, const BreathActivation<S>& activation,
                const TimeGrid& grid, Observer&& observe) {
  static_assert(lanes_of<S> == 1);
  Step<S>* advance = &step<S>;
  if constexpr (std::same_as<S, double>) advance = kernel().step;
  return simulate_lanes(model, parameters, activation, grid, observe, advance)[0];
}

}  // namespace trunk
