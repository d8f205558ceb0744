#include "dynamics/breath_chain.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "errors/input_error.hpp"

namespace trunk {
namespace {

/// Returns true if something in the model depends on the time.
bool has_courses(const Model& model) {
  const auto varies = [](const PiecewiseLinear& course) { return course.events().size() > 1; };
  const auto any_varies = [&](const auto& loads) {
    return std::any_of(loads.begin(), loads.end(), [&](const auto& load) { return varies(load.magnitude); });
  };
  return varies(model.abdomen.target) || (model.pleura && varies(model.pleura->airway_pressure)) ||
         any_varies(model.focal_forces) || any_varies(model.pressures) ||
         any_varies(model.imposed_displacements) ||
         std::any_of(model.bodies.begin(), model.bodies.end(),
                     [](const RigidBody& body) { return body.motion == RigidBody::Motion::driven; });
}

}  // namespace

BreathChain::BreathChain(const Model& model, double dt_s, Damping damping)
    : model_(model),
      rest_volume_(enclosed_volume<double>(model.lung, model.rest)),
      dt_s_(dt_s),
      damping_(damping) {
  if (has_courses(model))
    throw InputError({}, "a load, the abdominal volume or a rigid part follows a course of one breath",
                     "a trunk that only its muscle moves", "fit the mean breath");
  begin_at_rest(0.0);
}

void BreathChain::begin_at_rest(double at_s) {
  kept_ = {rest_state<double>(model_), at_s, {}, 0.0, at_s};
  next_reached_ = false;
}

Ending BreathChain::begin_repeating(const Trial<double>& trial, double period_s, double start_s,
                                    double at_s) {
  // The period may not be a whole number of steps: the breath that is simulated begins at `at_s`.
  Trial<double> shifted = trial;
  shifted.activation.onset_s += start_s - at_s;
  shifted.activation.period_s = period_s;
  const TimeGrid grid{dt_s_, dt_s_, damping_, Start::periodic};
  State<double> state;
  Ending ending = simulate(model_, shifted.parameters, shifted.activation, grid,
                           [&](int step, double, const State<double>& at_step, const StepReport<double>&) {
                             if (step == 0) state = at_step;
                           });
  if (!ending.completed()) return ending;
  // The breath in whose activation `at_s` lies began the last onset before it.
  const double since_onset_s = at_s - start_s - trial.activation.onset_s;
  const double breaths = std::floor(since_onset_s / period_s);
  kept_ = {std::move(state), at_s, trial.activation, trial.parameters.muscle, start_s + breaths * period_s};
  kept_.activation.period_s = 0.0;
  next_reached_ = false;
  return ending;
}

void BreathChain::prepare(const Parameters<double>& p) {
  const Parameters<double>& q = prepared_for_;
  if (workspace_.dt_s == dt_s_ && p.elasticity == q.elasticity && p.damping == q.damping &&
      p.abdomen_factor == q.abdomen_factor)
    return;
  workspace_ = make_workspace(model_, p, dt_s_, damping_);
  prepared_for_ = p;
}

BreathChain::Curve BreathChain::attempt(const Trial<double>& trial, double start_s, double end_s,
                                        double keep_s) {
  constexpr int steps_between_checks = 16;
  const double onset_s = start_s + trial.activation.onset_s, reach_m = height(model_);
  if (keep_s < onset_s) throw std::logic_error("the next breath cannot begin before this one");
  prepare(trial.parameters);
  BreathActivation<double> activation = trial.activation;
  activation.period_s = 0.0;
  const int steps = static_cast<int>(std::ceil((end_s - kept_.time_s) / dt_s_));
  const int keep = static_cast<int>(std::floor((keep_s - kept_.time_s) / dt_s_));
  State<double> state = kept_.state;
  Curve curve{{}, kept_.time_s, dt_s_, {}};
  next_reached_ = false;
  for (int n = 0;; ++n) {
    const double time_s = kept_.time_s + n * dt_s_;
    curve.volume.push_back(state.lung_gain);
    if (n == keep) {
      next_ = {state, time_s, activation, trial.parameters.muscle, start_s};
      next_reached_ = true;
    }
    if (n >= steps) {
      curve.ending = make_ending(Ending::Status::completed, n, time_s);
      require_lung(rest_volume_ + *std::min_element(curve.volume.begin(), curve.volume.end()), curve.ending);
      return curve;
    }
    const bool new_breath = time_s >= onset_s;
    Parameters<double> p = trial.parameters;
    if (!new_breath) p.muscle = kept_.muscle;
    const double active =
        new_breath ? activation(time_s - start_s) : kept_.activation(time_s - kept_.start_s);
    state.time_s = 0.0;  // nothing depends on it
    const bool held = kernel().step(model_, p, active, state, workspace_).ok;
    const bool here = n % steps_between_checks != 0 || within_reach(model_, state, reach_m);
    if (held && here) continue;
    curve.ending =
        make_ending(held ? Ending::Status::diverged : Ending::Status::volume_lost, n, time_s + dt_s_);
    return curve;
  }
}

void BreathChain::accept() {
  if (!next_reached_) throw std::logic_error("there is no attempt to accept, or it did not get so far");
  kept_ = next_;
  next_reached_ = false;
}

}  // namespace trunk
