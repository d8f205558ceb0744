#pragma once

#include <vector>

#include "math/rotation.hpp"
#include "model/model.hpp"

namespace trunk {

/// Where a rigid body is: its centre, and how it is turned from rest.
template <Scalar S>
struct Pose {
  Vec3<S> centre;
  Rotation<S> rotation;
};

/// Where a body in that pose takes a point of its rest shape, m.
template <Scalar S>
Vec3<S> placed(const RigidBody& body, const Pose<S>& pose, const Vec3d& rest) noexcept {
  return pose.centre + turn(pose.rotation, lift<S>(rest - body.centre));
}

/// What evolves.
template <Scalar S>
struct State {
  std::vector<Vec3<S>> position;  // [particles] m
  std::vector<Vec3<S>> previous;  // [particles] m, a step earlier: it is how they move
  struct Contact {
    Mask<S> touching;
    Mask<S> sticking;  // held by friction
    S press{0.0};  // with friction: m, how far inside the surface put the particle back: dt^2 / (m + dt c)
                   // times the force
  };
  std::vector<Contact> contact;  // [supports]
  S multiplier{0.0};             // of the volume constraint
  struct Body {
    Pose<S> pose;
    Vec3<S> velocity;          // m/s, of the centre
    Vec3<S> angular_momentum;  // kg m2/s, about the centre
  };
  std::vector<Body> body;  // [bodies]
  double time_s = 0.0;
};

/// The mean velocity of a particle in the last step, of dt_s, m/s.
template <Scalar S>
Vec3<S> velocity(const State<S>& state, std::size_t particle, double dt_s) noexcept {
  return S(1.0 / dt_s) * (state.position[particle] - state.previous[particle]);
}

/// At rest, at time 0.
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

}  // namespace trunk
