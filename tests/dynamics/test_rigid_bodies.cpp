#include <algorithm>
#include <cmath>

#include "support/catch.hpp"
#include "support/trunks.hpp"

using namespace trunk;
using namespace trunk::test;

namespace {

std::vector<int> first(int count) {
  std::vector<int> particles;
  for (int i = 0; i < count; ++i) particles.push_back(i);
  return particles;
}

RigidBody free_rigid(std::vector<int> particles) {
  RigidBody body;
  body.name = "body";
  body.motion = RigidBody::Motion::free;
  body.particles = std::move(particles);
  return body;
}

/// All particles of an uneven body in one rigid component: three different moments of inertia.
Model rigid_box() {
  const Mesh mesh = box(0.2, 0.1, 0.15);
  Model model = free_body(mesh, Reaction::variational, 0.2);
  carry(free_rigid(first(8)), model);
  return model;
}

const Parameters<double> undamped{500.0, 0.0, 0.0};

/// How far the distances between carried particles are from those at rest, m.
double stretched(const Model& model, const std::vector<int>& particles, const std::vector<Vec3d>& x) {
  double worst = 0.0;
  for (int a : particles)
    for (int b : particles) {
      const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
      worst = std::max(worst, std::abs(norm(x[i] - x[j]) - norm(model.rest[i] - model.rest[j])));
    }
  return worst;
}

Vec3d spin_of(const Model& model, const State<double>& state) {
  return detail::inverse_inertia_times(model.bodies[0], state.body[0].pose.rotation,
                                       state.body[0].angular_momentum);
}

/// Relative error of the kinetic energy after a second of free tumbling.
double energy_drift(double dt_s) {
  const Model model = rigid_box();
  State<double> state = rest_state<double>(model);
  state.body[0].angular_momentum = {2e-3, 5e-3, 1e-3};
  Workspace<double> w = make_workspace(model, undamped, dt_s);
  const auto energy = [&] { return 0.5 * dot(spin_of(model, state), state.body[0].angular_momentum); };
  const double at_start = energy();
  for (int n = 0; n < static_cast<int>(std::lround(1.0 / dt_s)); ++n) step(model, undamped, 0.0, state, w);
  return std::abs(energy() / at_start - 1.0);
}

}  // namespace

TEST_CASE("A body without forces keeps its angular momentum to the bit and its shape to round-off",
          "[property][dynamics]") {
  const Model model = rigid_box();
  State<double> state = rest_state<double>(model);
  const Vec3d momentum{2e-3, 5e-3, 1e-3};
  state.body[0].angular_momentum = momentum;
  Workspace<double> w = make_workspace(model, undamped, 1e-3);
  for (int n = 0; n < 2000; ++n) step(model, undamped, 0.0, state, w);
  CHECK(norm(state.body[0].angular_momentum - momentum) < 1e-16);
  CHECK(stretched(model, first(8), state.position) < 1e-14);
  CHECK(norm(state.position[0] - model.rest[0]) > 0.01);  // it does tumble
  CHECK(norm(state.body[0].pose.centre) < 1e-15);
}

TEST_CASE("The energy of a tumbling body is kept to first order of the time step", "[property][dynamics]") {
  const double coarse = energy_drift(1e-3), fine = energy_drift(0.5e-3);
  const double order = std::log2(coarse / fine);
  WARN("observed order of the energy of a free body: " << order);
  CHECK(coarse < 0.02);
  CHECK(order == Approx(1.0).margin(0.25));
}

TEST_CASE("Weight makes a body fall, and a force beside its centre also turns it", "[unit][dynamics]") {
  Model model = rigid_box();
  model.gravity = {0, 0, -9.81};
  State<double> state = rest_state<double>(model);
  Workspace<double> w = make_workspace(model, undamped, 1e-3);
  for (int n = 0; n < 100; ++n) step(model, undamped, 0.0, state, w);
  CHECK(state.body[0].velocity.z() == Approx(-0.981));
  CHECK(state.body[0].pose.centre.z() == Approx(-0.5 * 9.81 * 0.1 * 0.101));
  CHECK(norm(state.body[0].angular_momentum) < 1e-16);
  CHECK(norm(velocity(state, 3, w.dt_s) - state.body[0].velocity) < 1e-12);

  model = rigid_box();
  model.focal_forces = {{7, {0, 0, 1}, PiecewiseLinear({{0.0, 0.01}})}};
  state = rest_state<double>(model);
  step(model, undamped, 0.0, state, w);
  const Vec3d torque = cross(model.rest[7], {0, 0, 0.01});
  CHECK(norm(state.body[0].angular_momentum - 1e-3 * torque) < 1e-18);
  CHECK(norm(state.body[0].velocity - Vec3d{0, 0, 1e-3 * 0.01 / 1.6}) < 1e-18);
}

TEST_CASE("Damping slows the fall and the rotation of a body like that of single particles",
          "[unit][dynamics]") {
  const Parameters<double> damped{0.0, 0.0, 4.0};
  const Model model = rigid_box();
  State<double> state = rest_state<double>(model);
  state.body[0].velocity = {0.1, 0, 0};
  state.body[0].angular_momentum = {0, 0, 1e-3};
  Workspace<double> w = make_workspace(model, damped, 1e-3);
  step(model, damped, 0.0, state, w);
  CHECK(state.body[0].velocity.x() == Approx(0.1 / (1.0 + 1e-3 * 4.0 / 0.2)).epsilon(1e-12));
  CHECK(state.body[0].angular_momentum.z() == Approx(1e-3 / (1.0 + 1e-3 * 4.0 / 0.2)).epsilon(1e-12));
}

TEST_CASE("An elastic body with a rigid part keeps its momentum and its angular momentum",
          "[property][dynamics]") {
  Random random(71);
  const Mesh mesh = icosphere(0.1, 1);
  Model model = free_body(mesh, Reaction::variational, 0.2);
  carry(free_rigid(first(7)), model);
  State<double> state = rest_state<double>(model);
  for (std::size_t i = 7; i < mesh.position.size(); ++i)
    state.previous[i] = state.position[i] += random.vector(5e-3);
  Workspace<double> w = make_workspace(model, undamped, 1e-3);
  const auto momenta = [&] {
    Vec3d linear = model.bodies[0].mass * state.body[0].velocity;
    Vec3d angular = state.body[0].angular_momentum + cross(state.body[0].pose.centre, linear);
    for (std::size_t i = 7; i < mesh.position.size(); ++i) {
      linear += model.mass[i] * velocity(state, i, w.dt_s);
      angular += cross(state.position[i], model.mass[i] * velocity(state, i, w.dt_s));
    }
    return std::pair{linear, angular};
  };
  double moved = 0.0;
  std::pair<double, double> sizes{0.0, 0.0};  // sizes of the exchanged momenta
  for (int n = 0; n < 500; ++n) {
    step(model, undamped, 0.0, state, w);
    sizes.first += model.bodies[0].mass * norm(state.body[0].velocity);
    sizes.second += norm(state.body[0].angular_momentum);
    moved = std::max(moved, norm(state.body[0].angular_momentum));
  }
  const auto [linear, angular] = momenta();
  WARN("momentum " << norm(linear) << " of " << sizes.first << ", angular " << norm(angular) << " of "
                   << sizes.second);
  CHECK(norm(linear) < 1e-12 * sizes.first);
  CHECK(norm(angular) < 1e-12 * sizes.second);
  CHECK(moved > 1e-6);  // the body does move
  CHECK(stretched(model, first(7), state.position) < 1e-14);
}

TEST_CASE("A free body in a held volume keeps its shape, and the volume is held, to round-off",
          "[property][dynamics]") {
  Scenario scenario = without_lung("healthy");
  scenario.time.duration_s = 2.5;
  scenario.rigid = {{"central_tendon", RigidBody::Motion::free, {}, "", {"here"}}};
  const Trunk trunk = make_trunk(scenario);
  const auto& tendon = trunk.mesh.named("central_tendon");
  double volume_error = 0.0, stretch = 0.0, turned = 0.0;
  const Ending ending =
      simulate(trunk.model, scenario.parameters, scenario.activation, scenario.time,
               [&](int, double, const State<double>& state, const StepReport<double>&) {
                 const double volume = enclosed_volume<double>(trunk.model.abdomen.triangles, state.position);
                 volume_error = std::max(volume_error, std::abs(volume / trunk.model.abdomen.rest - 1.0));
                 stretch = std::max(stretch, stretched(trunk.model, tendon, state.position));
                 turned = std::max(turned, norm(state.body[0].pose.rotation.v));
               });
  WARN("free tendon: volume error " << volume_error << ", stretch " << stretch << " m, turn " << turned);
  CHECK(ending.completed());
  CHECK(volume_error < 1e-13);
  CHECK(stretch < 1e-13);
}

TEST_CASE("A driven body follows its course with its particles", "[unit][dynamics]") {
  Model model = free_body(box(0.2, 0.1, 0.15), Reaction::variational, 0.2);
  RigidBody body;
  body.name = "hinged";
  body.motion = RigidBody::Motion::driven;
  body.particles = first(8);
  body.imposed = {{0.1, 0, 0},
                  {0, 0, 1},
                  PiecewiseLinear({{0.0, 0.0}, {0.5, std::numbers::pi / 2}}),
                  {0, 0, 1},
                  PiecewiseLinear({{0.0, 0.0}, {0.5, 0.02}})};
  carry(body, model);
  State<double> state = rest_state<double>(model);
  Workspace<double> w = make_workspace(model, undamped, 1e-3);
  for (int n = 0; n < 500; ++n) step(model, undamped, 0.0, state, w);
  for (std::size_t i = 0; i < 8; ++i) {
    const Vec3d r = model.rest[i] - Vec3d{0.1, 0, 0};
    CHECK(norm(state.position[i] - Vec3d{0.1 - r.y(), r.x(), r.z() + 0.02}) < 1e-12);
  }
}

TEST_CASE("An impossible rigid component is refused", "[unit][dynamics]") {
  Model model = free_body(box(0.2, 0.1, 0.15), Reaction::variational, 0.2);
  CHECK_THROWS_WITH(carry(free_rigid({0, 1}), model), Contains("on a line"));
  CHECK_THROWS_WITH(carry(free_rigid({}), model), Contains("carries no particle"));
  CHECK_THROWS_WITH(carry(free_rigid({0, 1, 99}), model), Contains("99"));
  carry(free_rigid({0, 1, 2}), model);
  CHECK_THROWS_WITH(carry(free_rigid({2, 3, 4}), model), Contains("two rigid bodies"));
  model.supports.push_back({5, 0, {}, {0, 0, 1}, {}});
  CHECK_THROWS_WITH(require_valid(model), Contains("is free"));
}
