#include "forces/pressure.hpp"

#include "support/catch.hpp"
#include "support/trunks.hpp"

using namespace trunk;
using namespace trunk::test;

namespace {

PiecewiseLinear constant(double value) {
  return PiecewiseLinear({{0.0, value}});
}

std::vector<Vec3d> forces(const std::vector<Triangle>& triangles, const PiecewiseLinear& pressure,
                          const std::vector<Vec3d>& x, double time_s = 1.0) {
  std::vector<Vec3d> force(x.size());
  add_pressure<double>(std::vector<PressureLoad>{{triangles, pressure}}, time_s, x, force);
  return force;
}

}  // namespace

TEST_CASE("A pressure pushes each corner of a triangle with a third of the area times the pressure",
          "[unit][forces]") {
  const std::vector<Vec3d> x{{0, 0, 0}, {0.2, 0, 0}, {0, 0.3, 0}, {1, 1, 1}};  // faces up
  const auto force = forces({{0, 1, 2}}, constant(100.0), x);
  for (std::size_t i = 0; i < 3; ++i) CHECK(norm(force[i] - Vec3d{0, 0, -1.0}) < 1e-14);  // 100 * 0.03 / 3
  CHECK(norm(force[3]) == 0.0);
}

TEST_CASE("A pressure follows its course in time and adds to other forces", "[unit][forces]") {
  const std::vector<Vec3d> x{{0, 0, 0}, {0.2, 0, 0}, {0, 0.3, 0}};
  const PiecewiseLinear course({{1.0, 0.0}, {2.0, 100.0}});
  CHECK(largest(forces({{0, 1, 2}}, course, x, 0.5)) == 0.0);
  CHECK(forces({{0, 1, 2}}, course, x, 1.5)[0].z() == Approx(-0.5));
  CHECK(forces({{0, 1, 2}}, course, x, 9.0)[0].z() == Approx(-1.0));
  std::vector<Vec3d> force(3, Vec3d{1, 2, 3});
  const PressureLoad load{{{0, 1, 2}}, constant(100.0)};
  add_pressure<double>(std::vector<PressureLoad>{load, load}, 0.0, x, force);
  CHECK(norm(force[1] - Vec3d{1, 2, 1}) < 1e-14);
}

TEST_CASE("A pressure on a closed surface neither pushes nor turns it as a whole", "[property][forces]") {
  Random random(91);
  for (const Mesh& mesh : closed_meshes()) {
    INFO(mesh.name);
    const auto x = deformed(mesh.position, 0.02, random);
    const auto force = forces(mesh.triangles, constant(1000.0), x);
    REQUIRE(largest(force) > 1e-3);
    CHECK(norm(total(force)) < 1e-12 * largest(force));
    CHECK(norm(total_moment(x, force)) < 1e-12 * largest(force));
  }
}

TEST_CASE("The work of a pressure on a closed surface is minus pressure times the change of volume",
          "[property][forces]") {
  Random random(92);
  const double pressure = 1000.0, h = 1e-6;
  for (const Mesh& mesh : closed_meshes()) {
    INFO(mesh.name);
    const auto x = deformed(mesh.position, 0.02, random);
    const auto force = forces(mesh.triangles, constant(pressure), x);
    double worst = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i)
      for (const Vec3d& axis : {Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}}) {
        auto before = x, after = x;
        before[i] -= h * axis;
        after[i] += h * axis;
        const double slope = (enclosed_volume<double>(mesh.triangles, after) -
                              enclosed_volume<double>(mesh.triangles, before)) /
                             (2.0 * h);
        worst = std::max(worst, std::abs(dot(force[i], axis) + pressure * slope));
      }
    CHECK(worst < 1e-8 * largest(force));
  }
}

TEST_CASE("A pressure follows the surface as it turns", "[property][forces]") {
  Random random(93);
  const Mesh mesh = star();
  const std::vector<Triangle> some(mesh.triangles.begin(), mesh.triangles.begin() + 7);
  const RigidMotion motion = random_motion(random);
  std::vector<Vec3d> moved;
  for (const Vec3d& p : mesh.position) moved.push_back(motion(p));
  auto turned = forces(some, constant(1000.0), mesh.position);
  REQUIRE(norm(total(turned)) > 1e-3);
  const double size = largest(turned);
  for (Vec3d& f : turned) f = motion.turn(f);
  CHECK(largest(difference(forces(some, constant(1000.0), moved), turned)) < 1e-12 * size);
}

TEST_CASE("A pressure on the abdominal wall pushes the diaphragm up and leaves air in the lung",
          "[property][forces]") {
  Scenario scenario = without_lung("healthy");
  scenario.parameters.muscle = 0.0;
  scenario.time.duration_s = 1.0;
  RegionLoad load;
  load.kind = RegionLoad::Kind::pressure;
  load.region = "pelvis,abdominal_wall";
  load.magnitude = PiecewiseLinear({{0.0, 0.0}, {0.5, 300.0}});
  scenario.loads = {load};
  const Trunk trunk = make_trunk(scenario);
  REQUIRE(trunk.model.pressures.size() == 1);
  // pelvic floor 12, and two bands of 24 from the pelvis up to the upper ring of the wall
  CHECK(trunk.model.pressures[0].triangles.size() == 60);
  const BreathRun run = run_breath(trunk, scenario, 0);
  CHECK(run.ending.completed());
  CHECK(run.delta_v.back() < -10e-6);
}
