#pragma once

#include "constraints/displacement.hpp"
#include "constraints/rigid_bodies.hpp"
#include "constraints/volume_and_contact.hpp"
#include "forces/field.hpp"
#include "forces/focal.hpp"
#include "forces/membrane.hpp"
#include "forces/muscle.hpp"
#include "forces/pleura.hpp"
#include "forces/pressure.hpp"
#include "forces/shape_memory.hpp"
#include "model/state.hpp"
#include "model/workspace.hpp"

namespace trunk {

/// The result of one step.
template <Scalar S>
struct StepReport {
  S pressure_Pa{0.0};          // inside the held volume, above its rest value
  S pleural_pressure_Pa{0.0};  // that acted in the step, above its rest value
  Mask<S> ok;                  // false if the volume was not restored or a number is not finite
};

/// The type of `step`.
template <Scalar S>
using Step = StepReport<S>(const Model&, const Parameters<S>&, const S&, State<S>&, Workspace<S>&) noexcept;

/// Calculates all forces at the current positions, N, and what the constraints need of these positions.
/// (state, activation) => force, area, pleura
template <Scalar S>
void calc_forces(const Model& model, const Parameters<S>& parameters, const S& activation,
                 const State<S>& state, Workspace<S>& w) noexcept {
  set_gravity<S>(model, w.force);
  add_shape_memory<S>(model.shape_memory, w.ring_stiffness, state.position, w.reactions, w.force);
  add_muscle<S>(model.fibres, activation * parameters.muscle, state.position, w.force);
  add_membrane<S>(model.membrane, state.position, w.force);
  add_focal<S>(model.focal_forces, state.time_s, w.force);
  add_pressure<S>(model.pressures, state.time_s, state.position, w.force);
  calc_held_areas(model, state, w);
  if (w.pleura.present) add_pleural_force(model, parameters, state, w);
}

/// Predicts the positions at the end of the step by semi-implicit Euler (our choice). With implicit damping
/// v' = (m v + dt F) / (m + dt c), with centred damping v' = ((m - dt c / 2) v + dt F) / (m + dt c / 2), and
/// x' = x + dt v'. Here dt v is the movement of the particle in the last step. (state, force) => next
template <Scalar S>
void predict(const State<S>& state, Workspace<S>& w) noexcept {
  for_all(w.moving, [&](std::size_t i) {
    w.next[i] = state.position[i] + (hadamard(w.retained[i], state.position[i] - state.previous[i]) +
                                     hadamard(w.force_weight[i], w.force[i]));
  });
}

/// Makes the corrected positions of particles and bodies the state. (next, body) => state
template <Scalar S>
void accept(const Model& model, const S& multiplier, Workspace<S>& w, State<S>& state) noexcept {
  std::swap(state.previous, state.position);
  std::swap(state.position, w.next);
  accept_bodies(model, multiplier, w, state);
  state.multiplier = multiplier;
  state.lung_gain = volume_of_fans<S>(w.lung_fans, state.position) - S(w.lung_rest);
  state.time_s += w.dt_s;
}

/// Advances the state by one step of w.dt_s: forces, integration, constraints. It allocates nothing.
template <Scalar S>
StepReport<S> step(const Model& model, const Parameters<S>& parameters, const S& activation, State<S>& state,
                   Workspace<S>& w) noexcept {
  calc_forces(model, parameters, activation, state, w);
  predict(state, w);
  const double end_s = state.time_s + w.dt_s;
  predict_bodies(model, state, end_s, w);
  impose_displacements<S>(model, end_s, w.next);
  calc_planes(model, state, w);
  const double fraction = model.abdomen.target.empty() ? 1.0 : model.abdomen.target(end_s);
  const Projection<S> projection =
      project_volume_and_supports(model, S(fraction * model.abdomen.rest), state, w);
  accept(model, projection.multiplier, w, state);
  const S pressure_per_multiplier(1.0 / (w.dt_s * w.dt_s));
  return {pressure_per_multiplier * projection.multiplier,
          w.pleura.pressure + pressure_per_multiplier * projection.pleural, projection.found};
}

}  // namespace trunk
