#pragma once

#include <vector>

#include "model/model.hpp"
#include "model/parameters.hpp"
#include "model/state.hpp"

namespace trunk {

/// The velocity on which viscous damping acts in a step (our choice).
///  - implicit: the velocity at the end of the step. It is stable for any damping and of first order in dt:
///    particles move as if they were heavier by dt c / 2.
///  - centred: the mean of the velocities at the start and the end, which adds no mass. It is calm if dt c <
///    2 m.
enum class Damping { implicit, centred };

/// For each ring: its force on the particle in its middle, the parts of its reactions on the neighbours, and
/// twice its area vector (see RingForces). Each field is [particles], by the particle in the middle.
template <Scalar S>
struct RingReactions {
  std::vector<Vec3<S>> on_particle, share, tilt, spin, area;

  void resize(std::size_t particles) {
    for (auto* field : {&on_particle, &share, &tilt, &spin, &area}) field->resize(particles);
  }
};

/// The scratch memory of one simulation. Its sizes are set once, so that a step allocates nothing.
template <Scalar S>
struct Workspace {
  double dt_s = 0.0;
  double damped_at_end = 1.0;         // the share of the velocity at the end of a step on which damping acts
  Mask<S> running = S(0.0) < S(1.0);  // false: the lane has ended, and the others do not wait for it

  // (model, parameters, dt) => constant during a run
  bool elastic_volume = false;             // the held surface is elastic: the forces give its rings' areas
  std::vector<S> ring_stiffness;           // [rings] N/m
  std::vector<HalfOpenRange> moving;       // particles that something can move
  std::vector<HalfOpenRange> held_pushed;  // particles around the held volume that forces can move
  RingTable held_fans;                     // fans of the triangles around it that can move
  double held_still = 0.0;                 // m3, the share of all other triangles in it
  RingTable lung_fans;                     // fans of the lung's triangles that can move
  double lung_rest = 0.0;                  // m3, their share in the lung volume at rest
  // Weights along the free axes of a particle: of its movement in the last step, m' / M; of the force on it,
  // dt^2 / M in s2/kg; and of a push by the constraints, 1 / M in 1/kg. Implicit damping has M = m + dt c and
  // m' = m, centred damping M = m + dt c / 2 and m' = m - dt c / 2.
  std::vector<Vec3<S>> retained, force_weight, push_weight;  // [particles]

  // scratch of one step
  std::vector<Vec3<S>> force;  // [particles] N
  RingReactions<S> reactions;
  std::vector<Vec3<S>> next;       // [particles] m, predicted, then corrected by the constraints
  std::vector<Vec3<S>> direction;  // [particles] m per unit of the volume's multiplier

  /// The tangent plane of a support where its particle is, and the motion of that particle as if the support
  /// were absent. Inside is where normal . (x - predicted) + excess <= 0; normal . push = 1.
  struct Plane {
    Vec3<S> normal, push;
    Vec3<S> carried;           // m, how far the surface itself moved there in this step
    Vec3<S> predicted;         // m
    Vec3<S> direction;         // m per unit of the volume's multiplier
    Vec3<S> pleural;           // m per unit of the pleural multiplier
    S excess{0.0}, rate{0.0};  // how far outside `predicted` is, and its growth per unit of the multiplier
    S pleural_rate{0.0};       // and per unit of the pleural multiplier
  };
  std::vector<Plane> plane;  // [supports]

  struct Body {
    S inverse_effective_mass;  // as for particles; constant during a run
    S retained;                // momentum mass over effective mass
    Pose<S> pose;              // at the end of the step
    Vec3<S> angular_momentum;  // kg m2/s
    // movement per unit of the volume's multiplier
    Vec3<S> linear, angular, moment;
  };
  std::vector<Body> body;  // [bodies]

  /// The surface on which the pleural pressure acts, and the resistance to the flow of this step.
  struct Pleura {
    bool present = false;
    // constant during a run
    // The moving particles of the lung: those of the dome, whose lung ring is their abdominal ring turned
    // over; those with a support; and others.
    std::vector<HalfOpenRange> dome, others;
    std::vector<std::size_t> supports;
    RingTable rings;                    // of the lung, around particles off the dome
    std::vector<HalfOpenRange> solved;  // particles that the correction of volume and flow moves
    // scratch of one step
    std::vector<Vec3<S>> gradient;         // [particles] m2, of the lung volume at the start of the step
    std::vector<Vec3<S>> push;             // [particles] m per unit of the pleural multiplier
    std::vector<Vec3<S>> next, direction;  // [particles] as those of the workspace, without resistance; the
                                           // direction of the dome is minus its push
    S pressure{0.0};                       // Pa, known at the start of the step
    S coupling{0.0};                       // the multiplier per m3 that leaves the lung in the step
    S moved{0.0};                          // m3, that entered the lung in the last step
  } pleura;
};

/// Sets the surface on which the pleural pressure acts. held: the rings of the held volume that forces move.
template <Scalar S>
void prepare_pleura(const Model& model, const RingTable& held, Workspace<S>& w) {
  auto& p = w.pleura;
  const std::size_t n = model.particles();
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  const std::vector<bool> moving = moving_particles(model), pushed = pushed_particles(model);
  const RingTable facing = only_those(model.lung_rings, [&](int vertex, auto) { return moving[at(vertex)]; });
  const RingTable turned = turned_over(held);
  std::vector<bool> supported(n, false);
  for (const Support& support : model.supports) supported[at(support.particle)] = true;
  p.rings = only_those(facing, [&](int vertex, auto ring) {
    return supported[at(vertex)] || !contains(turned, vertex, ring);
  });
  std::vector<bool> dome(n, false), others(n, false), solved(n, false);
  for (const int vertex : held.vertex) solved[at(vertex)] = true;
  for (const int vertex : facing.vertex) solved[at(vertex)] = solved[at(vertex)] || pushed[at(vertex)];
  for (const int vertex : facing.vertex) dome[at(vertex)] = true;
  for (const int vertex : p.rings.vertex) {
    dome[at(vertex)] = false;
    others[at(vertex)] = true;
  }
  for (std::size_t s = 0; s < model.supports.size(); ++s)
    if (others[at(model.supports[s].particle)]) {
      p.supports.push_back(s);
      others[at(model.supports[s].particle)] = false;
    }
  p.dome = ranges(dome);
  p.others = ranges(others);
  p.solved = ranges(solved);
  for (auto* field : {&p.gradient, &p.push, &p.next, &p.direction}) field->resize(n);
}

/// Returns a workspace with all its sizes and with the values that stay constant during a run. It allocates.
template <Scalar S>
Workspace<S> make_workspace(const Model& model, const Parameters<S>& parameters, double dt_s,
                            Damping damping = Damping::implicit) {
  const double at_end = damping == Damping::implicit ? 1.0 : 0.5;
  const auto damped_later = [&](double weight) { return S(at_end * dt_s * weight) * parameters.damping; };
  const auto damped_before = [&](double weight) {
    return S((1.0 - at_end) * dt_s * weight) * parameters.damping;
  };
  Workspace<S> w;
  w.dt_s = dt_s;
  w.damped_at_end = at_end;
  const ShapeMemory& memory = model.shape_memory;
  for (std::size_t r = 0; r < memory.rings.size(); ++r) {
    const S share(memory.abdominal_share[r]);
    const S factor = S(1.0) + share * (parameters.abdomen_factor - S(1.0));
    w.ring_stiffness.push_back(S(memory.stiffness_weight[r]) * factor * parameters.elasticity);
  }
  for (std::size_t i = 0; i < model.particles(); ++i) {
    const S dt(dt_s), mass(model.mass[i]), one(1.0);
    const S per_mass = one / (mass + damped_later(model.damping_weight[i]));
    const S kept = (mass - damped_before(model.damping_weight[i])) * per_mass;
    const auto along_free_axes = [&](const S& weight) {
      return scaled(model.mobility[i], Vec3<S>{weight, weight, weight});
    };
    w.retained.push_back(along_free_axes(kept));
    w.force_weight.push_back(along_free_axes(dt * dt * per_mass));
    w.push_weight.push_back(along_free_axes(per_mass));
  }
  w.force.resize(model.particles());
  w.reactions.resize(model.particles());
  for (const Vec3d& p : model.rest) w.next.push_back(lift<S>(p));  // particles that never move stay there
  w.direction.resize(model.particles());
  w.moving = ranges(moving_particles(model));
  const std::vector<bool> pushed = pushed_particles(model);
  const RingTable held = only_those(
      model.abdomen.rings, [&](int vertex, auto) { return pushed[static_cast<std::size_t>(vertex)]; });
  w.elastic_volume = contains(memory.rings, held);
  std::vector<bool> held_pushed(model.particles(), false);
  for (const int vertex : held.vertex) held_pushed[static_cast<std::size_t>(vertex)] = true;
  w.held_pushed = ranges(held_pushed);
  auto [moving, still] = by_motion(model.abdomen.fans, model);
  w.held_fans = std::move(moving);
  w.held_still = volume_of_fans<double>(still, model.rest);
  w.lung_fans = by_motion(model.lung_fans, model).moving;
  w.lung_rest = volume_of_fans<double>(w.lung_fans, model.rest);
  w.pleura.present = model.pleura.has_value();
  if (w.pleura.present) prepare_pleura(model, held, w);
  w.plane.resize(model.supports.size());
  for (const RigidBody& body : model.bodies) {
    const S mass(body.mass), effective_mass = mass + damped_later(body.damping_weight);
    const S retained = (mass - damped_before(body.damping_weight)) / effective_mass;
    w.body.push_back({S(1.0) / effective_mass, retained, {lift<S>(body.centre), {}}, {}, {}, {}, {}});
  }
  return w;
}

}  // namespace trunk
