#include "constraints/contact.hpp"

#include <cmath>

#include "dynamics/step.hpp"
#include "support/catch.hpp"
#include "support/trunks.hpp"

using namespace trunk;
using namespace trunk::test;

namespace {

constexpr double free_fall = 9.81, tick_s = 1e-3;
const Parameters<double> loose{0.0, 0.0, 0.0};

/// One particle of a body without any stiffness, over a surface that faces up through its rest position.
Model on_surface(double friction, const Vec3d& gravity, double curvature = 0.0) {
  Model model = free_body(octahedron(0.1), Reaction::variational, 0.2);
  RigidBody ground;
  ground.name = "ground";
  carry(ground, model);
  Support support{0, 0, model.rest[0], {0, 0, -1}, {}};  // inside is above
  support.curvature[0] = {curvature, 0, 0};
  support.curvature[1] = {0, curvature, 0};
  model.supports = {support};
  model.friction = friction;
  model.gravity = gravity;
  return model;
}

State<double> after(const Model& model, double time_s, const Vec3d& start_velocity = {}) {
  State<double> state = rest_state<double>(model);
  state.previous[0] = state.position[0] - tick_s * start_velocity;
  Workspace<double> w = make_workspace(model, loose, tick_s);
  for (int n = 0; n < static_cast<int>(std::lround(time_s / tick_s)); ++n) step(model, loose, 0.0, state, w);
  return state;
}

Vec3d tilted(double angle) {
  return {free_fall * std::sin(angle), 0, -free_fall * std::cos(angle)};
}

}  // namespace

TEST_CASE("A particle pressed on a surface stays on it and pushes with its weight", "[unit][constraints]") {
  const Model model = on_surface(0.5, {0, 0, -free_fall});
  const State<double> state = after(model, 0.1);
  CHECK(norm(state.position[0] - model.rest[0]) < 1e-16);
  CHECK(state.contact[0].touching);
  CHECK(state.contact[0].press == Approx(free_fall * tick_s * tick_s));  // dt^2 / m times the force
}

TEST_CASE("A particle lifts off freely", "[unit][constraints]") {
  const Model model = on_surface(0.9, {0, 0, free_fall});
  const State<double> state = after(model, 0.1);
  CHECK_FALSE(state.contact[0].touching);
  CHECK(state.position[0].z() - model.rest[0].z() == Approx(0.5 * free_fall * 0.1 * 0.101));
}

TEST_CASE("On a slope below the angle of friction a particle sticks; above it, it slides by Coulomb's law",
          "[property][constraints]") {
  const double friction = 0.4, steep = 0.6, time_s = 0.2;
  for (const double angle : {0.1, 0.2, 0.35}) {
    const Model model = on_surface(friction, tilted(angle));
    CAPTURE(angle);
    // It is pressed for the first time in the first step, and sticks from the second on.
    CHECK(norm(after(model, time_s).position[0] - model.rest[0]) < 2.0 * free_fall * tick_s * tick_s);
    CHECK(after(model, time_s).contact[0].sticking);
  }
  const Model model = on_surface(friction, tilted(steep));
  const double slid = after(model, time_s).position[0].x() - model.rest[0].x();
  const double acceleration = free_fall * (std::sin(steep) - friction * std::cos(steep));
  CHECK(slid == Approx(0.5 * acceleration * time_s * time_s).epsilon(0.02));
  const Model smooth = on_surface(0.0, tilted(steep));
  CHECK(after(smooth, time_s).position[0].x() - smooth.rest[0].x() ==
        Approx(0.5 * free_fall * std::sin(steep) * time_s * (time_s + tick_s)));
}

TEST_CASE("Friction brings a sliding particle to rest and does not turn it back", "[property][constraints]") {
  const Model model = on_surface(0.5, {0, 0, -free_fall});
  const double speed = 0.5, stopping = speed * speed / (2.0 * 0.5 * free_fall);
  const State<double> state = after(model, 0.5, {speed, 0, 0});
  CHECK(state.position[0].x() - model.rest[0].x() == Approx(stopping).epsilon(0.03));
  CHECK(norm(velocity(state, 0, tick_s)) < 1e-12);
}

TEST_CASE("A sliding particle follows the curve of a hollow surface", "[property][constraints]") {
  const double curvature = 5.0;
  const Model model = on_surface(0.0, {0, 0, -free_fall}, curvature);
  State<double> state = rest_state<double>(model);
  state.previous[0] = state.position[0] - tick_s * Vec3d{0.3, 0.1, 0};
  Workspace<double> w = make_workspace(model, loose, tick_s);
  double deepest = -1.0, highest = 0.0;
  for (int n = 0; n < 300; ++n) {
    step(model, loose, 0.0, state, w);
    deepest = std::max(deepest, outside(model, state, state.position, model.supports[0]));
    highest = std::max(highest, state.position[0].z() - model.rest[0].z());
  }
  WARN("on a curved surface: farthest outside " << deepest << " m");
  CHECK(deepest < 1e-8);
  CHECK(highest == Approx(0.1 / (2 * free_fall)).epsilon(0.05));  // v^2 / 2g: it swings up the bowl
}

TEST_CASE("A rib surface that moves takes particles along that stick, but not those that slide",
          "[property][constraints]") {
  for (const double friction : {0.0, 1.0}) {
    Model model = on_surface(friction, {0, 0, -free_fall});
    model.bodies[0].motion = RigidBody::Motion::driven;
    model.bodies[0].imposed = {{}, {0, 0, 1}, {}, {1, 0, 0}, PiecewiseLinear({{0.0, 0.0}, {1.0, 0.05}})};
    const State<double> state = after(model, 0.2);
    CAPTURE(friction);
    const double speed = 0.05,
                 catching_up = speed * speed / (2.0 * free_fall);  // the surface starts with a jerk
    CHECK(state.position[0].x() - model.rest[0].x() ==
          Approx(friction > 0 ? 0.01 - catching_up : 0.0).margin(3e-5));
  }
}

TEST_CASE("With friction between ribs and zone of apposition, volume and ribs hold and the breath is smaller",
          "[property][constraints][slow]") {
  double smooth_volume = 0.0;
  for (const double friction : {0.0, 0.3}) {
    Scenario scenario = shipped("healthy");
    scenario.tissue.rib_friction = friction;
    const Trunk trunk = make_trunk(scenario);
    double volume_error = 0.0, deepest = -1.0;
    int stuck = 0;
    simulate(trunk.model, scenario.parameters, scenario.activation, scenario.time,
             [&](int, double, const State<double>& state, const StepReport<double>& report) {
               REQUIRE(report.ok);
               const double volume = enclosed_volume<double>(trunk.model.abdomen.triangles, state.position);
               volume_error = std::max(volume_error, std::abs(volume / trunk.model.abdomen.rest - 1.0));
               for (std::size_t s = 0; s < trunk.model.supports.size(); ++s) {
                 deepest =
                     std::max(deepest, outside(trunk.model, state, state.position, trunk.model.supports[s]));
                 stuck += state.contact[s].sticking;
               }
             });
    const double delta_v = run_breath(trunk, scenario, 0).measures.delta_v;
    WARN("friction " << friction << ": delta V " << 1e6 * delta_v << " ml, volume error " << volume_error
                     << ", farthest outside " << deepest << " m, stuck " << stuck);
    CHECK(volume_error < 1e-10);
    CHECK(deepest < 1e-10);
    CHECK((stuck > 0) == (friction > 0.0));
    if (friction == 0.0) smooth_volume = delta_v;
    if (friction > 0.0) CHECK(delta_v < 0.999 * smooth_volume);
  }
}
