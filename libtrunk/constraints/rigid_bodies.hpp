#pragma once

#include "model/state.hpp"
#include "model/workspace.hpp"

namespace trunk {

/// Returns the pose of a driven body at `time_s`; a fixed body stays at rest.
inline Pose<double> imposed_pose(const RigidBody& body, double time_s) noexcept {
  const ImposedMotion& m = body.imposed;
  if (body.motion != RigidBody::Motion::driven) return {body.centre, {}};
  return {body.centre + m.shift(time_s) * m.direction, rotation_about(m.axis, m.angle(time_s))};
}

namespace detail {

/// Puts the carried particles where the body's pose takes them. (pose) => position
template <Scalar S>
void place(const Model& model, const RigidBody& body, const Pose<S>& pose,
           std::span<Vec3<S>> position) noexcept {
  for (int carried : body.particles) {
    const auto i = static_cast<std::size_t>(carried);
    position[i] = placed(body, pose, model.rest[i]);
  }
}

/// Returns the inverse inertia about the centre, for the rotated body, times a vector.
template <Scalar S>
Vec3<S> inverse_inertia_times(const RigidBody& body, const Rotation<S>& rotation, const Vec3<S>& a) noexcept {
  const Vec3<S> at_rest = turn_back(rotation, a);
  const auto row = [&](int k) { return dot(lift<S>(body.inverse_inertia[k]), at_rest); };
  return turn(rotation, Vec3<S>{row(0), row(1), row(2)});
}

/// Predicts one free body by Newton's and Euler's laws. The step is semi-implicit, and damping is implicit as
/// for particles. Without torque, the angular momentum is constant to round-off.
/// (state, force) => pose, angular_momentum
template <Scalar S>
void predict_free_body(const RigidBody& body, const typename State<S>::Body& now, const State<S>& state,
                       std::span<const Vec3<S>> force, double dt_s,
                       typename Workspace<S>::Body& next) noexcept {
  const S dt(dt_s);
  Vec3<S> total_force, torque;
  for (int carried : body.particles) {
    const auto i = static_cast<std::size_t>(carried);
    total_force += force[i];
    torque += cross(state.position[i] - now.pose.centre, force[i]);
  }
  const Vec3<S> velocity = next.retained * now.velocity + (dt * next.inverse_effective_mass) * total_force;
  next.pose.centre = now.pose.centre + dt * velocity;
  next.angular_momentum = next.retained * (now.angular_momentum + dt * torque);
  const Vec3<S> spin = inverse_inertia_times(body, now.pose.rotation, next.angular_momentum);
  next.pose.rotation = then(now.pose.rotation, small_rotation(dt * spin));
}

}  // namespace detail

/// Moves the free and driven bodies to the end of the step, with the particles that they carry.
/// (state, force) => body, next
template <Scalar S>
void predict_bodies(const Model& model, const State<S>& state, double end_s, Workspace<S>& w) noexcept {
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const RigidBody& body = model.bodies[b];
    if (body.motion == RigidBody::Motion::fixed) continue;
    if (body.motion == RigidBody::Motion::free) {
      detail::predict_free_body<S>(body, state.body[b], state, w.force, w.dt_s, w.body[b]);
    } else {
      const Pose<double> pose = imposed_pose(body, end_s);
      w.body[b].pose = {lift<S>(pose.centre), lift<S>(pose.rotation)};
    }
    detail::place<S>(model, body, w.body[b].pose, w.next);
  }
}

/// Calculates how a free body moves for one unit of the volume's multiplier: as under the forces dV/dP on its
/// particles, at the start of the step. (state, area, next) => body, direction
template <Scalar S>
void calc_body_directions(const Model& model, const State<S>& state, Workspace<S>& w) noexcept {
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const RigidBody& body = model.bodies[b];
    if (body.motion != RigidBody::Motion::free || body.held_rows.empty()) continue;
    auto& next = w.body[b];
    const auto vertex = [&](int row) {
      return static_cast<std::size_t>(model.abdomen.rings.vertex[static_cast<std::size_t>(row)]);
    };
    Vec3<S> push, moment;
    for (int row : body.held_rows) {
      const Vec3<S> gradient = S(1.0 / 6.0) * w.reactions.area[vertex(row)];
      push += gradient;
      moment += cross(state.position[vertex(row)] - state.body[b].pose.centre, gradient);
    }
    next.linear = next.inverse_effective_mass * push;
    next.moment = next.retained * moment;
    next.angular = detail::inverse_inertia_times(body, next.pose.rotation, next.moment);
    for (int row : body.held_rows) {
      const std::size_t i = vertex(row);
      w.direction[i] = next.linear + cross(next.angular, w.next[i] - next.pose.centre);
    }
  }
}

/// Moves the free bodies by `multiplier` times their directions, as rigid bodies. Returns whether the held
/// volume moves any body. (body, multiplier) => next
template <Scalar S>
bool place_corrected_bodies(const Model& model, const S& multiplier, Workspace<S>& w) noexcept {
  bool moved = false;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const RigidBody& body = model.bodies[b];
    if (body.motion != RigidBody::Motion::free || body.held_rows.empty()) continue;
    const auto& next = w.body[b];
    const Pose<S> pose{next.pose.centre + multiplier * next.linear,
                       then(next.pose.rotation, small_rotation(multiplier * next.angular))};
    detail::place<S>(model, body, pose, w.next);
    moved = true;
  }
  return moved;
}

/// Makes the corrected bodies the state, with the velocities that the constraints leave. (body, multiplier)
/// => state
template <Scalar S>
void accept_bodies(const Model& model, const S& multiplier, const Workspace<S>& w, State<S>& state) noexcept {
  const S rate(1.0 / w.dt_s);
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    if (model.bodies[b].motion == RigidBody::Motion::fixed) continue;
    const auto& next = w.body[b];
    auto& body = state.body[b];
    const Vec3<S> centre = next.pose.centre + multiplier * next.linear;
    body.velocity = rate * (centre - body.pose.centre);
    body.angular_momentum = next.angular_momentum + (rate * multiplier) * next.moment;
    body.pose = {centre, then(next.pose.rotation, small_rotation(multiplier * next.angular))};
  }
}

}  // namespace trunk
