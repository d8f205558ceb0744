#pragma once

#include <vector>

#include "model/model.hpp"
#include "model/parameters.hpp"
#include "model/state.hpp"

namespace trunk {

/// Scratch memory of one simulation, sized once: a step allocates nothing.
template <Scalar S>
struct Workspace {
  double dt_s = 0.0;
  Mask<S> running = S(0.0) < S(1.0);  // where it no longer holds, the lane has ended and is not waited for

  // (model, parameters, dt) => constant during a run
  std::vector<S> ring_stiffness;          // [rings] N/m
  std::vector<S> inverse_effective_mass;  // [particles] 1 / (m + dt c), 1/kg

  // scratch of one step
  std::vector<Vec3<S>> force;               // [particles] N
  std::vector<Vec3<S>> predicted;           // [particles] m, before the constraints
  std::vector<Vec3<S>> corrected;           // [particles] m, with the supports, then with the volume
  std::vector<Vec3<S>> direction;           // [particles] m per unit of the volume's multiplier
  std::vector<Vec3<S>> gradient;            // [held rings] m2
  std::vector<Vec3<S>> direction_gradient;  // [held rings]
  std::vector<Vec3<S>> free_direction;  // [supports] direction of a particle as if its support were absent

  /// The tangent plane of a support where its particle is: normal . x <= offset; normal . push = 1.
  struct Plane {
    Vec3<S> normal, push;
    S offset;
    Vec3<S> carried;  // m, how far the surface itself moved there in this step
  };
  std::vector<Plane> plane;  // [supports]

  struct Body {
    S inverse_effective_mass;  // 1 / (M + dt C), 1/kg; constant during a run
    S retained;                // M / (M + dt C)
    Pose<S> pose;              // at the end of the step
    Vec3<S> angular_momentum;  // kg m2/s
    // movement per unit of the volume's multiplier
    Vec3<S> linear, angular, moment;
  };
  std::vector<Body> body;  // [bodies]
};

/// Sizes the workspace and derives what stays constant during a run. Allocates.
template <Scalar S>
Workspace<S> make_workspace(const Model& model, const Parameters<S>& parameters, double dt_s) {
  Workspace<S> w;
  w.dt_s = dt_s;
  const ShapeMemory& memory = model.shape_memory;
  for (std::size_t r = 0; r < memory.rings.size(); ++r) {
    const S share(memory.abdominal_share[r]);
    const S factor = S(1.0) + share * (parameters.abdomen_factor - S(1.0));
    w.ring_stiffness.push_back(S(memory.stiffness_weight[r]) * factor * parameters.elasticity);
  }
  for (std::size_t i = 0; i < model.particles(); ++i)
    w.inverse_effective_mass.push_back(
        S(1.0) / (S(model.mass[i]) + S(dt_s * model.damping_weight[i]) * parameters.damping));
  w.force.resize(model.particles());
  w.predicted.resize(model.particles());
  w.corrected.resize(model.particles());
  w.direction.resize(model.particles());
  w.gradient.resize(model.abdomen.rings.size());
  w.direction_gradient.resize(model.abdomen.rings.size());
  w.free_direction.resize(model.supports.size());
  w.plane.resize(model.supports.size());
  for (const RigidBody& body : model.bodies) {
    const S effective_mass = S(body.mass) + S(dt_s * body.damping_weight) * parameters.damping;
    w.body.push_back(
        {S(1.0) / effective_mass, S(body.mass) / effective_mass, {lift<S>(body.centre), {}}, {}, {}, {}, {}});
  }
  return w;
}

}  // namespace trunk
