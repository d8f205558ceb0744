#pragma once

#include <vector>

#include "model/model.hpp"

namespace trunk {

/// What evolves.
template <Scalar S>
struct State {
  std::vector<Vec3<S>> position;  // [particles] m
  std::vector<Vec3<S>> velocity;  // [particles] m/s
  struct Contact {
    Mask<S> touching;
  };
  std::vector<Contact> contact;  // [supports] which particles touch the rib cage
  double time_s = 0.0;
};

/// At rest, at time 0.
template <Scalar S>
State<S> rest_state(const Model& model) {
  State<S> state;
  for (const Vec3d& p : model.rest) state.position.push_back(lift<S>(p));
  state.velocity.resize(model.particles());
  const Mask<S> nowhere = S(1.0) < S(0.0);
  state.contact.resize(model.supports.size(), {nowhere});
  return state;
}

}  // namespace trunk
