#pragma once

#include <algorithm>
#include <array>
#include <string>

#include "activation/breath_activation.hpp"
#include "dynamics/kernel.hpp"
#include "dynamics/lead.hpp"

namespace trunk {

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

/// Simulates all lanes over the grid, in lockstep, and returns their endings. The grid says how they start:
/// at rest at step 0, or each at rest before step 0, as long as its own lead. It calls
/// `observe(step, activation, state, report)` at step 0 and after each later step. A lane ends early if its
/// volume cannot be held or if a particle moves farther than the trunk is tall. Its values then mean nothing
/// and do not affect other lanes. Once all lanes have ended, `observe` is not called any more. `advance` is
/// `step`, compiled here or for another instruction set.
template <Scalar S, class Observer>
Endings<S> simulate_lanes(const Model& model, const Parameters<S>& parameters,
                          const BreathActivation<S>& activation, const TimeGrid& grid, Observer&& observe,
                          Step<S>* advance = &step<S>) {
  constexpr int steps_between_checks = 16;
  const State<S> rest = rest_state<S>(model);
  State<S> state = rest;
  Workspace<S> workspace = make_workspace(model, parameters, grid.dt_s, grid.damping);
  Endings<S> endings;
  const double reach_m = height(model);
  const int steps = grid.steps();
  const Beginning<S> beginning = beginning_of(model, parameters, grid);
  workspace.running = beginning.begun(beginning.earliest);
  StepReport<S> report{S(0.0), S(0.0), workspace.running};

  const auto begin = [&](int n) {
    const Mask<S> lanes = Mask<S>(beginning.begun(n) & !beginning.begun(n - 1));
    if (n == beginning.earliest || !any(lanes)) return;
    replace(lanes, rest, state);
    workspace.running = Mask<S>(workspace.running | lanes);
  };
  const auto end = [&](Ending::Status status, const Mask<S>& lanes, int n) {
    const Mask<S> ending = Mask<S>(workspace.running & lanes);
    if (!any(ending)) return;
    for (int i = 0; i < lanes_of<S>; ++i)
      if (in_lane(ending, i))
        endings[static_cast<std::size_t>(i)] = make_ending(status, std::max(0, n), n * grid.dt_s);
    workspace.running = Mask<S>(workspace.running & !ending);
  };

  for (int n = beginning.earliest;; ++n) {
    state.time_s = time_in_breath_s(grid, n);
    if (n <= 0) begin(n);
    const S active = grid.active(activation, n * grid.dt_s);
    if (n >= 0) observe(n, active, state, report);
    if (n == steps) break;
    report = advance(model, parameters, active, state, workspace);
    end(Ending::Status::volume_lost, !report.ok, n + 1);
    if ((n + 1) % steps_between_checks == 0 || n + 1 == steps)
      end(Ending::Status::diverged, !within_reach(model, state, reach_m), n + 1);
    if (!any(workspace.running) && all(beginning.begun(n))) return endings;
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
