#include <cmath>

#include "errors/input_error.hpp"
#include "support/catch.hpp"
#include "support/trunks.hpp"

using namespace trunk;
using namespace trunk::test;

namespace {

/// An elastic body with a stiffness for each ring, and a deformed shape of it.
struct Body {
  std::string name;
  ShapeMemory memory;
  std::vector<double> stiffness;  // [rings] N/m
  std::vector<Vec3d> rest, position;

  std::vector<Vec3d> forces() const { return forces_at(position); }
  std::vector<Vec3d> forces_at(const std::vector<Vec3d>& x) const {
    std::vector<Vec3d> force(x.size());
    add_to(force, x);
    return force;
  }
  void add_to(std::vector<Vec3d>& force, const std::vector<Vec3d>& x) const {
    RingReactions<double> reactions;
    reactions.resize(x.size());
    add_shape_memory<double>(memory, stiffness, x, reactions, force);
  }
  double energy_at(const std::vector<Vec3d>& x) const { return shape_memory_energy(memory, stiffness, x); }
};

std::vector<double> uneven(std::size_t n, Random& random) {
  std::vector<double> stiffness;
  for (std::size_t i = 0; i < n; ++i) stiffness.push_back(random.between(500, 5000));
  return stiffness;
}

/// Weights of the neighbours in the centres of their rings.
std::vector<double> uneven_weights(const ShapeMemory& memory, Random& random) {
  std::vector<double> weights;
  for_each_ring(memory.rings, [&](std::size_t, std::size_t, auto ring) {
    double sum = 0.0;
    for (std::size_t j = 0; j < ring.size(); ++j) sum += weights.emplace_back(random.between(0.1, 1.0));
    for (std::size_t j = weights.size() - ring.size(); j < weights.size(); ++j) weights[j] /= sum;
  });
  return weights;
}

std::vector<Body> bodies(Reaction reaction, Random& random) {
  std::vector<Body> all;
  for (const Mesh& mesh : closed_meshes()) {
    const ShapeMemory memory = free_body(mesh, reaction, 1.0).shape_memory;
    all.push_back({mesh.name, memory, uneven(memory.rings.size(), random), mesh.position,
                   deformed(mesh.position, 0.02, random)});
  }
  const Trunk trunk = make_template_trunk({}, {}, reaction);
  const std::size_t n = trunk.model.particles();
  const Surface abdomen("abdomen", trunk.mesh.abdomen, static_cast<int>(n));
  const std::vector<double> one(n, 1.0), none(n, 0.0);
  const ShapeMemory memory = make_shape_memory(abdomen, trunk.model.rest, one, none, reaction);
  all.push_back({"trunk", memory, uneven(memory.rings.size(), random), trunk.model.rest,
                 deformed(trunk.model.rest, 0.01, random)});
  if (reaction == Reaction::variational)
    for (std::size_t i = 0, count = all.size(); i < count; ++i) {
      Body weighted = all[i];
      weighted.name += ", weighted";
      weigh_neighbours(uneven_weights(weighted.memory, random), weighted.rest, weighted.memory);
      all.push_back(std::move(weighted));
    }
  return all;
}

/// Minus the slope of the energy, by central differences of fourth order, at one particle.
Vec3d downhill(const Body& body, std::size_t i) {
  const double h = 2e-5;
  const auto along = [&](const Vec3d& axis) {
    const auto energy = [&](double step) {
      std::vector<Vec3d> x = body.position;
      x[i] += step * axis;
      return body.energy_at(x);
    };
    return -(8.0 * (energy(h) - energy(-h)) - (energy(2 * h) - energy(-2 * h))) / (12.0 * h);
  };
  return {along({1, 0, 0}), along({0, 1, 0}), along({0, 0, 1})};
}

double sum_of_norms(const std::vector<Vec3d>& field) {
  double sum = 0.0;
  for (const Vec3d& a : field) sum += norm(a);
  return sum;
}

}  // namespace

TEST_CASE("Variational shape-memory forces are the negative gradient of their energy", "[property][forces]") {
  Random random(21);
  double worst = 0.0;
  for (const Body& body : bodies(Reaction::variational, random)) {
    const std::vector<Vec3d> force = body.forces();
    const double scale = largest(force);
    REQUIRE(scale > 1.0);  // N: the forces are large enough to compare
    for (std::size_t i = 0; i < force.size(); ++i) {
      const double error = norm(force[i] - downhill(body, i)) / scale;
      CAPTURE(body.name, i, error, scale);
      REQUIRE(error < 1e-10);
      worst = std::max(worst, error);
    }
  }
  WARN("largest deviation from finite differences, relative to the largest force: " << worst);
}

TEST_CASE("Published shape-memory forces are no gradient of that energy", "[property][forces]") {
  // This guards the test above: the test can distinguish the two reactions.
  Random random(21);
  const Body body = bodies(Reaction::published, random).back();
  const std::vector<Vec3d> force = body.forces();
  double worst = 0.0;
  for (std::size_t i = 0; i < force.size(); ++i) worst = std::max(worst, norm(force[i] - downhill(body, i)));
  CHECK(worst > 0.01 * largest(force));
}

TEST_CASE("Variational shape-memory forces sum to zero and so do their torques", "[property][forces]") {
  Random random(22);
  double worst_force = 0.0, worst_torque = 0.0;
  for (const Body& body : bodies(Reaction::variational, random)) {
    const std::vector<Vec3d> force = body.forces();
    const double scale = sum_of_norms(force);
    REQUIRE(scale > 1.0);
    const double net_force = norm(total(force)) / scale;
    const double net_torque = norm(total_moment(body.position, force)) / scale;  // arms of about 0.1 m
    CAPTURE(body.name, net_force, net_torque);
    CHECK(net_force < 1e-14);
    CHECK(net_torque < 1e-14);
    worst_force = std::max(worst_force, net_force);
    worst_torque = std::max(worst_torque, net_torque);
  }
  WARN("net force / sum of forces: " << worst_force << ", net torque: " << worst_torque << " m");
}

TEST_CASE("The published reaction sums to zero but leaves a torque", "[property][forces]") {
  Random random(23);
  for (const Body& body : bodies(Reaction::published, random)) {
    const std::vector<Vec3d> force = body.forces();
    const double scale = sum_of_norms(force);
    const double net_torque = norm(total_moment(body.position, force)) / scale;
    CAPTURE(body.name, net_torque);
    CHECK(norm(total(force)) / scale < 1e-14);
    CHECK(net_torque > 1e-5);  // nine orders above round-off
  }
}

TEST_CASE("Equal weights give the bits of no weights", "[unit][forces]") {
  Random random(28);
  for (Body& body : bodies(Reaction::variational, random)) {
    if (!body.memory.extra_weight.empty()) continue;
    const std::vector<Vec3d> before = body.forces();
    std::vector<double> equal;
    for_each_ring(body.memory.rings, [&](std::size_t, std::size_t, auto ring) {
      equal.insert(equal.end(), ring.size(), 1.0 / static_cast<double>(ring.size()));
    });
    weigh_neighbours(equal, body.rest, body.memory);
    INFO(body.name);
    REQUIRE(body.memory.extra_weight.size() == equal.size());
    CHECK(largest(difference(body.forces(), before)) == 0.0);
  }
}

TEST_CASE("Both reactions pull the particle itself alike", "[unit][forces]") {
  // One stiff ring alone: F = k (T - P) on its particle, the reactions elsewhere.
  for (const Mesh& mesh : closed_meshes()) {
    Random random(24);
    const std::vector<Vec3d> x = deformed(mesh.position, 0.02, random);
    const ShapeMemory memory = free_body(mesh, Reaction::variational, 1.0).shape_memory;
    const auto vertex = static_cast<std::size_t>(memory.rings.vertex.back());
    std::vector<double> stiffness(memory.rings.size(), 0.0);
    stiffness.back() = 1000.0;
    std::vector<Vec3d> variational(x.size()), published(x.size());
    RingReactions<double> reactions;
    reactions.resize(x.size());
    add_shape_memory<Reaction::variational, double>(memory, stiffness, x, reactions, variational);
    add_shape_memory<Reaction::published, double>(memory, stiffness, x, reactions, published);
    INFO(mesh.name);
    REQUIRE(norm(published[vertex]) > 0.1);
    CHECK(norm(variational[vertex] - published[vertex]) == 0.0);
    // E = F^2 / 2k for a single actuator.
    CHECK(shape_memory_energy(memory, stiffness, x) ==
          Approx(dot(published[vertex], published[vertex]) / 2000.0).epsilon(1e-12));
  }
}

TEST_CASE("The rest shape is an equilibrium at any place and in any direction", "[property][forces]") {
  Random random(25);
  for (const Reaction reaction : {Reaction::variational, Reaction::published})
    for (const Body& body : bodies(reaction, random)) {
      INFO(body.name);
      CHECK(largest(body.forces_at(body.rest)) < 5000.0 * 1e-15);  // k times round-off of 0.1 m
      const RigidMotion motion = random_motion(random);
      std::vector<Vec3d> moved = body.rest;
      for (Vec3d& p : moved) p = motion(p);
      CHECK(largest(body.forces_at(moved)) < 5000.0 * 1e-14);
    }
}

TEST_CASE("Shape-memory energy ignores rigid motion and the forces turn with it", "[property][forces]") {
  Random random(26);
  for (const Reaction reaction : {Reaction::variational, Reaction::published})
    for (const Body& body : bodies(reaction, random)) {
      INFO(body.name);
      const RigidMotion motion = random_motion(random);
      std::vector<Vec3d> moved = body.position, turned_force = body.forces();
      for (Vec3d& p : moved) p = motion(p);
      for (Vec3d& f : turned_force) f = motion.turn(f);
      CHECK(body.energy_at(moved) == Approx(body.energy_at(body.position)).epsilon(1e-11));
      CHECK(largest(difference(body.forces_at(moved), turned_force)) < 1e-11 * largest(turned_force));
    }
}

TEST_CASE("Forces are added to those that are there", "[unit][forces]") {
  Random random(27);
  const Body body = bodies(Reaction::variational, random).front();
  std::vector<Vec3d> force(body.position.size(), Vec3d{1, 2, 3});
  body.add_to(force, body.position);
  for (Vec3d& f : force) f -= Vec3d{1, 2, 3};
  CHECK(largest(difference(force, body.forces())) < 1e-13);
}

TEST_CASE("A ring with too many neighbours is refused by name", "[unit][forces]") {
  const Mesh many = bipyramid(static_cast<int>(max_valence) + 1);
  CHECK_THROWS_WITH(free_body(many, Reaction::variational, 1.0),
                    Contains(many.name) && Contains("65 neighbours") && Contains("64"));
  CHECK_NOTHROW(free_body(bipyramid(static_cast<int>(max_valence)), Reaction::variational, 1.0));
}
