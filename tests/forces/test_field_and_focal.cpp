#include "forces/field.hpp"
#include "forces/focal.hpp"
#include "support/catch.hpp"
#include "support/trunks.hpp"

using namespace trunk;
using namespace trunk::test;

TEST_CASE("Gravity sets every force to the weight of its particle", "[unit][forces]") {
  Model model = free_body(octahedron(0.1), Reaction::variational, 0.2);
  model.gravity = {0, 0, -9.81};
  model.mass[2] = 0.5;
  std::vector<Vec3d> force(model.particles(), Vec3d{7, 7, 7});  // left from the step before
  set_gravity<double>(model, force);
  for (std::size_t i = 0; i < force.size(); ++i) {
    CHECK(force[i].x() == 0.0);
    CHECK(force[i].y() == 0.0);
    CHECK(force[i].z() == Approx(-9.81 * (i == 2 ? 0.5 : 0.2)));
  }
}

TEST_CASE("A focal force acts on its particle along its direction, and its size follows its course in time",
          "[unit][forces]") {
  const std::vector<FocalForce> forces{{1, {0, 3, 4}, PiecewiseLinear({{1.0, 0.0}, {2.0, 2.0}})}};
  const auto at = [&](double time_s) {
    std::vector<Vec3d> force(3, Vec3d{1, 0, 0});
    add_focal<double>(forces, time_s, force);
    return force;
  };
  CHECK(norm(at(0.5)[1] - Vec3d{1, 0, 0}) == 0.0);
  CHECK(norm(at(1.5)[1] - Vec3d{1, 3, 4}) < 1e-14);  // the direction is not normalised
  CHECK(norm(at(9.0)[1] - Vec3d{1, 6, 8}) < 1e-14);
  CHECK(norm(at(9.0)[0] - Vec3d{1, 0, 0}) == 0.0);
}

TEST_CASE("Two focal forces on one particle add up", "[unit][forces]") {
  const PiecewiseLinear one({{0.0, 1.0}});
  std::vector<Vec3d> force(1);
  add_focal<double>(std::vector<FocalForce>{{0, {1, 0, 0}, one}, {0, {0, 2, 0}, one}}, 0.0, force);
  CHECK(norm(force[0] - Vec3d{1, 2, 0}) == 0.0);
}
