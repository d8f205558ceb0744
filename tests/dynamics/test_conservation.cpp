#include <cmath>

#include "support/catch.hpp"
#include "support/trunks.hpp"

using namespace trunk;
using namespace trunk::test;

namespace {

/// A body that flies, turns and wobbles, without constraints.
struct FreeFlight {
  Model model;
  Parameters<double> parameters;
  State<double> state;
  Workspace<double> w;

  FreeFlight(const Mesh& mesh, Reaction reaction, double damping, double dt_s)
      : model(free_body(mesh, reaction, 0.2)),
        parameters{2000.0, 0.0, damping},
        state(rest_state<double>(model)),
        w(make_workspace(model, parameters, dt_s)) {
    Random random(61);
    for (Vec3d& p : state.position) p += random.vector(0.004);
    for (std::size_t i = 0; i < state.position.size(); ++i)
      state.previous[i] = state.position[i] - dt_s * (random.vector(0.2) + Vec3d{0.3, -0.2, 0.1});
  }
  void advance() {
    calc_forces(model, parameters, 0.0, state, w);
    predict(state, w);
    accept(model, 0.0, w, state);
  }
  std::vector<Vec3d> momenta() const {
    std::vector<Vec3d> result;
    for (std::size_t i = 0; i < model.particles(); ++i)
      result.push_back(model.mass[i] * velocity(state, i, w.dt_s));
    return result;
  }
  double energy() const {
    double sum = shape_memory_energy(model.shape_memory, w.ring_stiffness, state.position);
    for (std::size_t i = 0; i < model.particles(); ++i)
      sum += 0.5 * model.mass[i] * dot(velocity(state, i, w.dt_s), velocity(state, i, w.dt_s));
    return sum;
  }
};

double largest_energy_change(const Mesh& mesh, double dt_s, double duration_s) {
  FreeFlight body(mesh, Reaction::variational, 0.0, dt_s);
  const double start = body.energy();
  double most = 0.0;
  for (int n = 0; n < std::lround(duration_s / dt_s); ++n) {
    body.advance();
    most = std::max(most, std::abs(body.energy() / start - 1.0));
  }
  return most;
}

std::vector<Mesh> flyers() {
  return {octahedron(0.1), icosphere(0.1, 1), torus(), bipyramid(9)};
}

}  // namespace

TEST_CASE("A free body keeps its linear and angular momentum", "[property][dynamics]") {
  double worst_linear = 0.0, worst_angular = 0.0;
  for (const Mesh& mesh : flyers()) {
    FreeFlight body(mesh, Reaction::variational, 0.0, 1e-3);
    const auto start = body.momenta();
    const Vec3d linear = total(start), angular = total_moment(body.state.position, start);
    REQUIRE(norm(linear) > 0.1);
    REQUIRE(norm(angular) > 1e-4);
    for (int n = 0; n < 1000; ++n) {
      body.advance();
      const auto now = body.momenta();
      worst_linear = std::max(worst_linear, norm(total(now) - linear) / norm(linear));
      worst_angular =
          std::max(worst_angular, norm(total_moment(body.state.position, now) - angular) / norm(angular));
    }
    CAPTURE(mesh.name, worst_linear, worst_angular);
    CHECK(worst_linear < 1e-11);
    CHECK(worst_angular < 1e-9);
  }
  WARN("relative drift over 1000 steps of linear momentum " << worst_linear << ", angular " << worst_angular);
}

TEST_CASE("A free body under the published reaction keeps linear but not angular momentum",
          "[property][dynamics]") {
  FreeFlight body(icosphere(0.1, 1), Reaction::published, 0.0, 1e-3);
  const Vec3d linear = total(body.momenta()), angular = total_moment(body.state.position, body.momenta());
  for (int n = 0; n < 200; ++n) body.advance();
  CHECK(norm(total(body.momenta()) - linear) < 1e-11 * norm(linear));
  CHECK(norm(total_moment(body.state.position, body.momenta()) - angular) > 1e-3 * norm(angular));
}

TEST_CASE("Without damping the energy of a free body drifts with order 1 in the time step",
          "[property][dynamics][slow]") {
  for (const Mesh& mesh : flyers()) {
    const double coarse = largest_energy_change(mesh, 1e-3, 1.0),
                 fine = largest_energy_change(mesh, 5e-4, 1.0),
                 finest = largest_energy_change(mesh, 2.5e-4, 1.0);
    CAPTURE(mesh.name, coarse, fine, finest);
    REQUIRE(finest > 1e-7);
    CHECK(std::log2(fine / finest) == Approx(1.0).margin(0.35));
    CHECK(finest < 0.02);
    // The drift is bounded: in ten times as long it does not become larger.
    CHECK(largest_energy_change(mesh, 5e-4, 10.0) < 2.0 * fine);
  }
}

TEST_CASE("With damping the energy of a free body always falls", "[property][dynamics][slow]") {
  for (const Mesh& mesh : flyers()) {
    FreeFlight body(mesh, Reaction::variational, 20.0, 1e-4);
    const double start = body.energy();
    double last = start, highest_rise = 0.0;
    for (int n = 0; n < 5000; ++n) {
      body.advance();
      const double now = body.energy();
      highest_rise = std::max(highest_rise, now - last);
      last = now;
    }
    CAPTURE(mesh.name, highest_rise / start, last / start);
    CHECK(highest_rise <= 1e-12 * start);
    CHECK(last < 1e-3 * start);
  }
}

TEST_CASE("Holding a volume does not change the linear momentum", "[property][dynamics]") {
  const Mesh mesh = icosphere(0.1, 1);
  FreeFlight body(mesh, Reaction::variational, 0.0, 1e-3);
  hold_volume(mesh, body.model);
  body.w = make_workspace(body.model, body.parameters, 1e-3);
  const Vec3d linear = total(body.momenta());
  for (int n = 0; n < 500; ++n) REQUIRE(step(body.model, body.parameters, 0.0, body.state, body.w).ok);
  CHECK(norm(total(body.momenta()) - linear) < 1e-11 * norm(linear));
}
