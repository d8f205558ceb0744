#pragma once

#include <vector>

#include "math/rotation.hpp"
#include "model/model.hpp"

namespace trunk {

/// Where a rigid body is: its centre, and its rotation from rest.
template <Scalar S>
struct Pose {
  Vec3<S> centre;
  Rotation<S> rotation;
};

/// Returns where a body in a pose takes a point of its rest shape, m.
template <Scalar S>
Vec3<S> placed(const RigidBody& body, const Pose<S>& pose, const Vec3d& rest) noexcept {
  return pose.centre + turn(pose.rotation, lift<S>(rest - body.centre));
}

/// Everything that changes during a simulation.
template <Scalar S>
struct State {
  std::vector<Vec3<S>> position;  // [particles] m
  std::vector<Vec3<S>> previous;  // [particles] m, one step earlier: this holds the velocities
  struct Contact {
    Mask<S> touching;
    Mask<S> sticking;  // friction holds it
    /// With friction: how far the surface pushed the particle back in, m: dt^2 / (m + dt c) times the force.
    S press{0.0};
  };
  std::vector<Contact> contact;  // [supports]
  S multiplier{0.0};             // of the volume constraint
  S lung_gain{0.0};              // m3, lung volume above rest
  struct Body {
    Pose<S> pose;
    Vec3<S> velocity;          // m/s, of the centre
    Vec3<S> angular_momentum;  // kg m2/s, about the centre
  };
  std::vector<Body> body;  // [bodies]
  double time_s = 0.0;
};

/// Returns the mean velocity of a particle in the last step, which took dt_s, m/s.
template <Scalar S>
Vec3<S> velocity(const State<S>& state, std::size_t particle, double dt_s) noexcept {
  return S(1.0 / dt_s) * (state.position[particle] - state.previous[particle]);
}

/// Returns the state at rest at time 0.
template <Scalar S>
State<S> rest_state(const Model& model) {
  State<S> state;
  for (const Vec3d& p : model.rest) state.position.push_back(lift<S>(p));
  state.previous = state.position;
  const Mask<S> nowhere = S(1.0) < S(0.0);
  state.contact.resize(model.supports.size(), {nowhere, nowhere, S(0.0)});
  for (const RigidBody& body : model.bodies) state.body.push_back({{lift<S>(body.centre), {}}, {}, {}});
  return state;
}

/// Replaces the lanes of a state where the mask is true.
template <Scalar S>
void replace(const Mask<S>& lanes, const State<S>& by, State<S>& state) noexcept {
  const auto put = [&](const auto& from, auto& to) { to = select(lanes, from, to); };
  const auto put_vector = [&](const Vec3<S>& from, Vec3<S>& to) { to = select<S>(lanes, from, to); };
  for (std::size_t i = 0; i < state.position.size(); ++i) {
    put_vector(by.position[i], state.position[i]);
    put_vector(by.previous[i], state.previous[i]);
  }
  for (std::size_t s = 0; s < state.contact.size(); ++s) {
    put(by.contact[s].touching, state.contact[s].touching);
    put(by.contact[s].sticking, state.contact[s].sticking);
    put(by.contact[s].press, state.contact[s].press);
  }
  put(by.multiplier, state.multiplier);
  put(by.lung_gain, state.lung_gain);
  for (std::size_t b = 0; b < state.body.size(); ++b) {
    const auto& from = by.body[b];
    auto& to = state.body[b];
    put(from.pose.rotation.w, to.pose.rotation.w);
    put_vector(from.pose.rotation.v, to.pose.rotation.v);
    put_vector(from.pose.centre, to.pose.centre);
    put_vector(from.velocity, to.velocity);
    put_vector(from.angular_momentum, to.angular_momentum);
  }
}

}  // namespace trunk
