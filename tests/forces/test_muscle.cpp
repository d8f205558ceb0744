#include "forces/muscle.hpp"

#include "support/catch.hpp"
#include "support/trunks.hpp"

using namespace trunk;
using namespace trunk::test;

namespace {

std::vector<Vec3d> muscle_forces(const std::vector<Fibre>& fibres, double stiffness,
                                 const std::vector<Vec3d>& x) {
  std::vector<Vec3d> force(x.size());
  add_muscle<double>(fibres, stiffness, x, force);
  return force;
}

/// 1/2 k |d|^2 summed over the fibres.
double muscle_energy(const std::vector<Fibre>& fibres, double stiffness, const std::vector<Vec3d>& x) {
  double energy = 0.0;
  for (const Fibre& f : fibres) {
    const Vec3d d = x[static_cast<std::size_t>(f.origin)] - x[static_cast<std::size_t>(f.insertion)];
    energy += 0.5 * stiffness * f.activity * dot(d, d);
  }
  return energy;
}

}  // namespace

TEST_CASE("A fibre pulls each end to the other", "[unit][forces]") {
  const auto force = muscle_forces({{0, 1, 1.0}}, 30.0, {{0, 0, 0}, {0, 0, 0.1}, {5, 5, 5}});
  CHECK(force[0].z() == Approx(3.0));
  CHECK(force[1].z() == Approx(-3.0));
  CHECK(norm(force[0] + force[1]) == 0.0);
  CHECK(norm(force[2]) == 0.0);
}

TEST_CASE("A paralysed fibre does not pull, and a half active one pulls half as much", "[unit][forces]") {
  const std::vector<Vec3d> x{{0, 0, 0}, {0.1, 0, 0}};
  CHECK(largest(muscle_forces({{0, 1, 0.0}}, 30.0, x)) == 0.0);
  CHECK(largest(muscle_forces({{0, 1, 0.5}}, 30.0, x)) == Approx(1.5));
}

TEST_CASE("Muscle forces are the negative gradient of their energy", "[property][forces]") {
  const Trunk trunk = make_template_trunk({}, Tissue{.paralysed = Side::left}, Reaction::variational);
  Random random(31);
  const std::vector<Vec3d> x = deformed(trunk.model.rest, 0.01, random);
  const auto& fibres = trunk.model.fibres;
  const auto force = muscle_forces(fibres, 30.0, x);
  REQUIRE(largest(force) > 1.0);
  const double h = 1e-4;
  for (std::size_t i = 0; i < x.size(); ++i)
    for (const Vec3d& axis : {Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}}) {
      std::vector<Vec3d> ahead = x, behind = x;
      ahead[i] += h * axis;
      behind[i] -= h * axis;
      const double slope =
          (muscle_energy(fibres, 30.0, ahead) - muscle_energy(fibres, 30.0, behind)) / (2 * h);
      REQUIRE(dot(force[i], axis) == Approx(-slope).margin(1e-9));
    }
}

TEST_CASE("Muscle forces sum to zero and so do their torques", "[property][forces]") {
  const Trunk trunk = make_template_trunk({}, {}, Reaction::variational);
  Random random(32);
  const std::vector<Vec3d> x = deformed(trunk.model.rest, 0.01, random);
  const auto force = muscle_forces(trunk.model.fibres, 30.0, x);
  CHECK(norm(total(force)) < 1e-13);
  CHECK(norm(total_moment(x, force)) < 1e-13);
}
