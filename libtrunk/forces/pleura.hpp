#pragma once

#include "model/state.hpp"
#include "model/workspace.hpp"

namespace trunk {

/// Adds the pleural pressure that is known at the start of a step: that of the airway less the lung's recoil,
/// and with centred damping also less half of the resistance to the flow of the last step. The other half, or
/// all of it with implicit damping, follows with the volume (see resist_flow). The force on a particle is the
/// pressure times the gradient of the lung volume. On the dome this is minus the gradient of the held volume.
/// The flow of the last step is taken along today's gradient, which makes centred damping of second order.
/// (state, area) => pleura, force
template <Scalar S>
void add_pleural_force(const Model& model, const Parameters<S>& parameters, const State<S>& state,
                       Workspace<S>& w) noexcept {
  auto& p = w.pleura;
  const S sixth(1.0 / 6.0);
  for_all(p.dome, [&](std::size_t i) { p.gradient[i] = -sixth * w.reactions.area[i]; });
  calc_ring_areas<S>(p.rings, state.position, p.gradient);
  for (const int vertex : p.rings.vertex) {
    auto& gradient = p.gradient[static_cast<std::size_t>(vertex)];
    gradient = sixth * gradient;
  }

  if (w.damped_at_end < 1.0 || model.friction > 0.0) {
    S moved(0.0);
    const auto flow = [&](std::size_t i) {
      moved = moved + dot(p.gradient[i], state.position[i] - state.previous[i]);
    };
    for_all(p.dome, flow);
    for_all(p.others, flow);
    for (const std::size_t s : p.supports) flow(static_cast<std::size_t>(model.supports[s].particle));
    p.moved = moved;
  }
  const S resistance = parameters.resistance + S(model.pleura->tube_resistance);
  const S before = S((1.0 - w.damped_at_end) / w.dt_s) * resistance * p.moved;
  p.pressure =
      S(model.pleura->airway_pressure(state.time_s)) - parameters.lung_elastance * state.lung_gain - before;
  p.coupling = S(w.damped_at_end * w.dt_s) * resistance;

  const auto push = [&](std::size_t i) {
    p.push[i] = hadamard(w.push_weight[i], p.gradient[i]);
    w.force[i] += p.pressure * p.gradient[i];
  };
  for_all(p.dome, push);
  for_all(p.others, push);
  for (const std::size_t s : p.supports) {
    const auto i = static_cast<std::size_t>(model.supports[s].particle);
    push(i);
    w.plane[s].pleural = p.push[i];
  }
}

}  // namespace trunk
