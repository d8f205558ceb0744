#include "forces/membrane.hpp"

#include <set>

#include "support/catch.hpp"
#include "support/trunks.hpp"

using namespace trunk;
using namespace trunk::test;

namespace {

/// A spring of another stiffness along every edge.
std::vector<MembraneEdge> springs(const Mesh& mesh, Random& random) {
  std::vector<MembraneEdge> edges;
  std::set<std::pair<int, int>> seen;
  for (const Triangle& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [a, b] = std::minmax(t[k], t[(k + 1) % 3]);
      const Vec3d along =
          mesh.position[static_cast<std::size_t>(b)] - mesh.position[static_cast<std::size_t>(a)];
      if (seen.emplace(a, b).second) edges.push_back({a, b, norm(along), random.between(100.0, 1000.0)});
    }
  return edges;
}

double energy(const std::vector<MembraneEdge>& edges, const std::vector<Vec3d>& x) {
  double sum = 0.0;
  for (const MembraneEdge& e : edges) {
    const double stretch =
        norm(x[static_cast<std::size_t>(e.b)] - x[static_cast<std::size_t>(e.a)]) - e.rest_length;
    sum += 0.5 * e.stiffness * stretch * stretch;
  }
  return sum;
}

std::vector<Vec3d> forces(const std::vector<MembraneEdge>& edges, const std::vector<Vec3d>& x) {
  std::vector<Vec3d> force(x.size());
  add_membrane<double>(edges, x, force);
  return force;
}

}  // namespace

TEST_CASE("Membrane forces are the negative gradient of the springs' energy", "[property][forces]") {
  Random random(81);
  for (const Mesh& mesh : closed_meshes()) {
    INFO(mesh.name);
    const auto edges = springs(mesh, random);
    const auto x = deformed(mesh.position, 0.02, random);
    const auto force = forces(edges, x);
    REQUIRE(largest(force) > 0.1);
    const double h = 1e-6;
    double worst = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i)
      for (const Vec3d& axis : {Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}}) {
        auto before = x, after = x;
        before[i] -= h * axis;
        after[i] += h * axis;
        const double slope = (energy(edges, after) - energy(edges, before)) / (2.0 * h);
        worst = std::max(worst, std::abs(slope + dot(force[i], axis)));
      }
    CHECK(worst < 1e-7 * largest(force));
  }
}

TEST_CASE("A membrane at rest has no force, also after a rigid motion, and its forces turn with it",
          "[property][forces]") {
  Random random(82);
  for (const Mesh& mesh : closed_meshes()) {
    INFO(mesh.name);
    const auto edges = springs(mesh, random);
    CHECK(largest(forces(edges, mesh.position)) == 0.0);
    const RigidMotion motion = random_motion(random);
    std::vector<Vec3d> moved;
    for (const Vec3d& p : mesh.position) moved.push_back(motion(p));
    CHECK(largest(forces(edges, moved)) < 1e-11);

    const auto x = deformed(mesh.position, 0.02, random);
    moved.clear();
    for (const Vec3d& p : x) moved.push_back(motion(p));
    auto turned = forces(edges, x);
    const double size = largest(turned);
    for (Vec3d& f : turned) f = motion.turn(f);
    CHECK(largest(difference(forces(edges, moved), turned)) < 1e-11 * size);
  }
}

TEST_CASE("The forces of a membrane sum to zero and so do their torques", "[property][forces]") {
  Random random(83);
  for (const Mesh& mesh : closed_meshes()) {
    INFO(mesh.name);
    const auto x = deformed(mesh.position, 0.02, random);
    const auto force = forces(springs(mesh, random), x);
    CHECK(norm(total(force)) < 1e-13 * largest(force));
    CHECK(norm(total_moment(x, force)) < 1e-13 * largest(force));
  }
}

TEST_CASE("A spring of the membrane pulls when longer and pushes when shorter, with its stiffness",
          "[unit][forces]") {
  const std::vector<MembraneEdge> edge{{0, 1, 0.1, 200.0}};
  CHECK(norm(forces(edge, {{0, 0, 0}, {0.15, 0, 0}})[0] - Vec3d{10, 0, 0}) < 1e-12);
  CHECK(norm(forces(edge, {{0, 0, 0}, {0, 0.05, 0}})[1] - Vec3d{0, 10, 0}) < 1e-12);
  std::vector<Vec3d> force(2, Vec3d{1, 1, 1});
  add_membrane<double>(edge, std::vector<Vec3d>{{0, 0, 0}, {0.15, 0, 0}}, force);
  CHECK(norm(force[0] - Vec3d{11, 1, 1}) < 1e-12);  // added to the forces that are there
}

TEST_CASE("With a membrane the trunk has a spring on every edge of abdomen and diaphragm, else none",
          "[unit][forces]") {
  Scenario scenario = without_lung("healthy");
  CHECK(make_trunk(scenario).model.membrane.empty());
  const double before = run_breath(make_trunk(scenario), scenario, 0).measures.delta_v;
  scenario.tissue.membrane_stiffness = 300.0;
  const Trunk trunk = make_trunk(scenario);
  CHECK(trunk.model.membrane.size() == 3 * trunk.mesh.abdomen.size() / 2);
  for (const MembraneEdge& e : trunk.model.membrane) CHECK(e.stiffness == 300.0);
  const double with = run_breath(trunk, scenario, 0).measures.delta_v;
  CHECK(with < before);
  CHECK(with > 0.0);
}
