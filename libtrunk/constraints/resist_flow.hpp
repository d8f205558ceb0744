#pragma once

#include "constraints/contact.hpp"

namespace trunk::detail {

/// The multiplier of the pleural resistance along that of the volume: at + rate lambda. Divided by dt^2 it is
/// the pressure -R V' that the flow of the step makes, or half of it with centred damping.
template <Scalar S>
struct PleuralMultiplier {
  S at{0.0}, rate{0.0};

  S operator()(const S& lambda) const noexcept { return at + lambda * rate; }
};

/// Sums over particles of the gradient of the lung volume times: the movement in the step, the direction of
/// the volume correction, and the push of the pleural multiplier.
template <Scalar S>
struct FlowSums {
  S moved{0.0}, along{0.0}, pushed{0.0};
};

/// Adds one particle to the sums.
template <Scalar S>
void add_flow(const State<S>& state, const Workspace<S>& w, std::size_t i, FlowSums<S>& sums) noexcept {
  const Vec3<S>& gradient = w.pleura.gradient[i];
  sums.moved = sums.moved + dot(gradient, w.next[i] - state.position[i]);
  sums.along = sums.along + dot(gradient, w.direction[i]);
  sums.pushed = sums.pushed + dot(gradient, w.pleura.push[i]);
}

/// Keeps the particles without a support as they are without resistance, and returns their sums. They do not
/// depend on what touches. (next, direction) => pleura, plane
template <Scalar S>
FlowSums<S> free_flow(const State<S>& state, Workspace<S>& w) noexcept {
  auto& p = w.pleura;
  FlowSums<S> sums;
  for_all(p.dome, [&](std::size_t i) {
    p.next[i] = w.next[i];
    sums.moved = sums.moved + dot(p.gradient[i], w.next[i] - state.position[i]);
    sums.pushed = sums.pushed + dot(p.gradient[i], p.push[i]);
  });
  sums.along = -sums.pushed;
  for_all(p.others, [&](std::size_t i) {
    p.next[i] = w.next[i];
    p.direction[i] = w.direction[i];
    add_flow(state, w, i, sums);
  });
  for (const std::size_t s : p.supports) {
    auto& plane = w.plane[s];
    plane.pleural_rate = dot(plane.normal, plane.pleural);
  }
  return sums;
}

/// Adds the resistance to the positions and directions that the contacts give, in the lanes of the mask. All
/// particles x of the lung are pushed by mu a, with a = g / (m + dt c) along free axes and along the surfaces
/// that they touch, and g the gradient of the lung volume. With x0 at the start of the step, the law is
/// mu = -dt R g . (x + lambda d + mu a - x0). So mu follows from sums, and is linear in lambda:
/// mu = mu0 + mu1 lambda, mu0 = -dt R g . (x - x0) / (1 + dt R g . a), mu1 = -dt R g . d / (1 + dt R g . a).
/// Then x += mu0 a and d += mu1 a. (contact, plane, pleura) => next, direction, multiplier
template <Scalar S>
void resist_flow(const Model& model, const State<S>& state, const Mask<S>& lanes, FlowSums<S> sums,
                 Workspace<S>& w, PleuralMultiplier<S>& multiplier) noexcept {
  auto& p = w.pleura;
  const auto particle = [&](std::size_t s) { return static_cast<std::size_t>(model.supports[s].particle); };
  for (const std::size_t s : p.supports) {
    const auto& plane = w.plane[s];
    const auto& contact = state.contact[s];
    const Vec3<S> slide =
        select(contact.sticking, Vec3<S>(), plane.pleural - plane.pleural_rate * plane.push);
    p.push[particle(s)] = select(contact.touching, slide, plane.pleural);
    add_flow(state, w, particle(s), sums);
  }
  const S share = -p.coupling / (S(1.0) + p.coupling * sums.pushed);
  multiplier.at = select(lanes, share * sums.moved, multiplier.at);
  multiplier.rate = select(lanes, share * sums.along, multiplier.rate);
  const S dome_rate = multiplier.rate - S(1.0);
  for_all(p.dome, [&](std::size_t i) {
    w.next[i] = p.next[i] + multiplier.at * p.push[i];
    w.direction[i] = dome_rate * p.push[i];
  });
  for_all(p.others, [&](std::size_t i) {
    w.next[i] = p.next[i] + multiplier.at * p.push[i];
    w.direction[i] = p.direction[i] + multiplier.rate * p.push[i];
  });
  for (const std::size_t s : p.supports) {
    const std::size_t i = particle(s);
    w.next[i] = select(lanes, w.next[i] + multiplier.at * p.push[i], w.next[i]);
    w.direction[i] = select(lanes, w.direction[i] + multiplier.rate * p.push[i], w.direction[i]);
  }
}

}  // namespace trunk::detail
