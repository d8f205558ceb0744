#include "constraints/displacement.hpp"

#include "support/catch.hpp"
#include "support/trunks.hpp"

using namespace trunk;
using namespace trunk::test;

namespace {

const PiecewiseLinear ramp({{0.0, 0.0}, {1.0, 0.010}});

}  // namespace

TEST_CASE("A displacement is imposed from rest, on its axes only", "[unit][constraints]") {
  Model model = free_body(octahedron(0.1), Reaction::variational, 0.2);
  model.imposed_displacements = {{2, {1, 0, 1}, {2, 0, -1}, ramp}};
  const Vec3d somewhere{0.5, 0.6, 0.7};
  std::vector<Vec3d> x(model.particles(), somewhere);
  impose_displacements<double>(model, 0.5, x);
  CHECK(x[2].x() == Approx(model.rest[2].x() + 0.010));
  CHECK(x[2].y() == 0.6);
  CHECK(x[2].z() == Approx(model.rest[2].z() - 0.005));
  CHECK(norm(x[1] - somewhere) == 0.0);
}

TEST_CASE("Displacements on different axes of one particle do not disturb each other",
          "[unit][constraints]") {
  Model model = free_body(octahedron(0.1), Reaction::variational, 0.2);
  model.imposed_displacements = {{0, {1, 0, 0}, {1, 0, 0}, ramp}, {0, {0, 1, 0}, {0, -1, 0}, ramp}};
  std::vector<Vec3d> x(model.particles());
  impose_displacements<double>(model, 9.0, x);
  CHECK(x[0].x() == Approx(model.rest[0].x() + 0.010));
  CHECK(x[0].y() == Approx(model.rest[0].y() - 0.010));
  CHECK(x[0].z() == 0.0);
}

TEST_CASE("A displaced region follows its course at every step, and the volume is still held",
          "[property][constraints]") {
  Scenario scenario = without_lung("healthy");
  scenario.parameters.muscle = 0.0;
  scenario.time.duration_s = 0.2;
  // The saddle and the domes move down by 5 mm on one axis and are free to slide sideways.
  scenario.loads = {{RegionLoad::Kind::displacement,
                     "central_tendon",
                     {0, 0, -1},
                     {0, 0, 1},
                     PiecewiseLinear({{0.0, 0.0}, {0.2, 0.005}}),
                     {"here"}}};
  const Trunk trunk = make_trunk(scenario);
  double sideways = 0.0, off_course = 0.0, volume_error = 0.0;
  const Ending ending =
      simulate(trunk.model, scenario.parameters, scenario.activation, scenario.time,
               [&](int, double, const State<double>& state, const StepReport<double>&) {
                 for (int particle : trunk.mesh.regions.at("central_tendon")) {
                   const auto i = static_cast<std::size_t>(particle);
                   const Vec3d moved = state.position[i] - trunk.model.rest[i];
                   off_course = std::max(off_course, std::abs(moved.z() + 0.005 * state.time_s / 0.2));
                   sideways = std::max(sideways, std::abs(moved.x()));
                 }
                 const double volume = enclosed_volume<double>(trunk.model.abdomen.triangles, state.position);
                 volume_error = std::max(volume_error, std::abs(volume / trunk.model.abdomen.rest - 1.0));
               });
  CAPTURE(off_course, sideways, volume_error);
  CHECK(ending.completed());
  CHECK(off_course < 1e-15);
  CHECK(sideways > 1e-6);
  CHECK(volume_error < 1e-13);
}
