#pragma once

#include "constraints/rigid_bodies.hpp"

namespace trunk {

/// Calculates the tangent plane of each support's surface at the predicted place of its particle. If the
/// constraints then move the particle by d in one step, the plane is off the surface by d^2 times the
/// curvature, which is below 1e-10 m (our choice). (next, body) => plane
template <Scalar S>
void calc_planes(const Model& model, const State<S>& state, Workspace<S>& w) noexcept {
  for (std::size_t s = 0; s < model.supports.size(); ++s) {
    const Support& support = model.supports[s];
    const auto b = static_cast<std::size_t>(support.body), i = static_cast<std::size_t>(support.particle);
    const RigidBody& body = model.bodies[b];
    const bool moves = body.motion != RigidBody::Motion::fixed;
    const Rotation<S>& rotation = w.body[b].pose.rotation;
    const Vec3<S> point = moves ? placed(body, w.body[b].pose, support.point) : lift<S>(support.point);
    auto& plane = w.plane[s];
    plane.predicted = w.next[i];
    const Vec3<S> apart = plane.predicted - point;
    const Vec3<S> at_rest = moves ? turn_back(rotation, apart) : apart;
    const Vec3<S> bend = at_rest.x() * lift<S>(support.curvature[0]) +
                         at_rest.y() * lift<S>(support.curvature[1]) +
                         at_rest.z() * lift<S>(support.curvature[2]);  // symmetric
    const Vec3<S> normal = lift<S>(support.normal) + bend;

    plane.normal = moves ? turn(rotation, normal) : normal;
    plane.push = (S(1.0) / dot(normal, normal)) * plane.normal;
    plane.excess = dot(plane.normal, apart) - S(0.5) * dot(bend, at_rest);
    if (!moves) continue;
    const Vec3<S> before =
        turn_back(state.body[b].pose.rotation, state.position[i] - state.body[b].pose.centre);
    plane.carried = w.body[b].pose.centre + turn(rotation, before) - state.position[i];
  }
}

namespace detail {

/// Returns the part of a vector along the surface.
template <Scalar S>
Vec3<S> along(const typename Workspace<S>::Plane& plane, const Vec3<S>& a) noexcept {
  return a - dot(plane.normal, a) * plane.push;
}

/// Puts the particles that touch back on their plane, in the lanes of the mask. The volume correction then
/// moves these particles along the plane only, and those that stick not at all.
/// (plane, contact) => next, direction
template <Scalar S>
void rest_on_supports(const Model& model, const State<S>& state, const Mask<S>& lanes,
                      Workspace<S>& w) noexcept {
  for (std::size_t s = 0; s < model.supports.size(); ++s) {
    const auto& plane = w.plane[s];
    const auto& contact = state.contact[s];
    const auto i = static_cast<std::size_t>(model.supports[s].particle);
    const Vec3<S> on_plane = plane.predicted - plane.excess * plane.push;
    const Vec3<S> slide = select(contact.sticking, Vec3<S>(), plane.direction - plane.rate * plane.push);
    w.next[i] = select(lanes, select(contact.touching, on_plane, plane.predicted), w.next[i]);
    w.direction[i] = select(lanes, select(contact.touching, slide, plane.direction), w.direction[i]);
  }
}

/// Returns how far outside a particle would be without its support. multiplier, pleural: those of the volume
/// and of the pleural resistance.
template <Scalar S>
S unsupported_excess(const typename Workspace<S>::Plane& plane, const S& multiplier,
                     const S& pleural) noexcept {
  return plane.excess + multiplier * plane.rate + pleural * plane.pleural_rate;
}

/// Returns true in the lanes where the particles that touch are those that would be outside otherwise.
template <Scalar S>
Mask<S> contacts_hold(const Model& model, const S& multiplier, const S& pleural, const Workspace<S>& w,
                      const State<S>& state) noexcept {
  Mask<S> hold = S(0.0) < S(1.0);
  for (std::size_t s = 0; s < model.supports.size(); ++s) {
    const Mask<S> outside = S(0.0) < unsupported_excess<S>(w.plane[s], multiplier, pleural);
    hold = Mask<S>(hold & (state.contact[s].touching == outside));
  }
  return hold;
}

/// Decides again, in the lanes of the mask, which particles touch: those that would be outside if the
/// correction moved them as if their support were absent. Returns true in the lanes where no support changed.
/// (plane) => contact
template <Scalar S>
Mask<S> update_touching(const Model& model, const S& multiplier, const S& pleural, const Mask<S>& lanes,
                        const Workspace<S>& w, State<S>& state) noexcept {
  Mask<S> settled = S(0.0) < S(1.0);
  for (std::size_t s = 0; s < model.supports.size(); ++s) {
    const Mask<S> outside = S(0.0) < unsupported_excess<S>(w.plane[s], multiplier, pleural);
    const Mask<S> before = state.contact[s].touching;
    state.contact[s].touching = select(lanes, outside, before);
    settled = Mask<S>(settled & (state.contact[s].touching == before));
  }
  return settled;
}

/// Records how far each support pushed its particle back. (contact, plane) => contact
template <Scalar S>
void record_press(const Model& model, const S& multiplier, const S& pleural, const Workspace<S>& w,
                  State<S>& state) noexcept {
  using std::sqrt;
  for (std::size_t s = 0; s < model.supports.size(); ++s) {
    const auto& plane = w.plane[s];
    const S excess = unsupported_excess<S>(plane, multiplier, pleural);
    state.contact[s].press =
        select(state.contact[s].touching, excess / sqrt(dot(plane.normal, plane.normal)), S(0.0));
  }
}

/// Applies Coulomb's law to the particles that touched at the last step, with the push of that step (our
/// choice; the push is thus one step late, and so are both multipliers that say where it would slide). A
/// particle that would slide less far than friction times the push sticks to the surface. Any other is held
/// back by that distance. A push of round-off, as at rest, makes no particle stick. (contact, multiplier) =>
/// plane, contact
template <Scalar S>
void apply_friction(const Model& model, State<S>& state, Workspace<S>& w) noexcept {
  using std::sqrt;
  const S nothing(1e-300), round_off(1e-13), pleural = w.pleura.coupling * w.pleura.moved;
  for (std::size_t s = 0; s < model.supports.size(); ++s) {
    auto& contact = state.contact[s];
    auto& plane = w.plane[s];
    const Vec3<S> carried =
        state.position[static_cast<std::size_t>(model.supports[s].particle)] + plane.carried;
    const Vec3<S> predicted_slide = along<S>(plane, plane.predicted - carried);
    const Vec3<S> unsupported =
        plane.predicted + state.multiplier * plane.direction - pleural * plane.pleural;
    const Vec3<S> slide = along<S>(plane, unsupported - carried);
    const S length = sqrt(dot(slide, slide) + nothing), limit = S(model.friction) * contact.press;
    contact.sticking = Mask<S>(contact.touching & (round_off < contact.press) & (length < limit));
    const Vec3<S> held_back = select(contact.sticking, predicted_slide, (limit / length) * slide);
    plane.predicted = select(contact.touching, plane.predicted - held_back, plane.predicted);
  }
}

}  // namespace detail
}  // namespace trunk
