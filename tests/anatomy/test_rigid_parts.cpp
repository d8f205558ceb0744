#include "anatomy/rigid_parts.hpp"

#include <algorithm>
#include <set>

#include "errors/input_error.hpp"
#include "math/units.hpp"
#include "scenarios/build_trunk.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"
#include "support/trunks.hpp"

using namespace trunk;
using namespace trunk::test;

namespace {

/// A half of the rib cage that swings outward by `degrees` until 2 s and back until 4 s: the handle of a
/// bucket, hinged on an axis from back to front through the top of the lung.
RigidPart swinging_half(const Scenario& scenario, const std::string& side, double degrees) {
  const TrunkMesh mesh = mesh_of(scenario);
  const double outward = rad_per_degree * (side == "right" ? -degrees : degrees);
  RigidPart part;
  part.region = "rib_cage_" + side;
  part.motion = RigidBody::Motion::driven;
  part.surface_for = "zone_of_apposition_" + side;
  part.imposed.point = mesh.rest[at(mesh.named("lung_top").front())];
  part.imposed.axis = {0, 1, 0};
  part.imposed.angle = PiecewiseLinear({{0.0, 0.0}, {2.0, outward}, {4.0, 0.0}});
  part.at = {side};
  return part;
}

struct Held {
  Ending ending;
  double volume_error = 0.0, farthest_outside = -1.0;
};

/// The errors of the constraints over a whole breath.
Held held_over(const Scenario& scenario, const Trunk& trunk) {
  Held held;
  held.ending = simulate(
      trunk.model, scenario.parameters, scenario.activation, scenario.time,
      [&](int, double, const State<double>& state, const StepReport<double>&) {
        const double volume = enclosed_volume<double>(trunk.model.abdomen.triangles, state.position);
        held.volume_error = std::max(held.volume_error, std::abs(volume / trunk.model.abdomen.rest - 1.0));
        for (const Support& s : trunk.model.supports)
          held.farthest_outside =
              std::max(held.farthest_outside, outside(trunk.model, state, state.position, s));
      });
  return held;
}

std::string message_about(Scenario scenario, std::vector<RigidPart> parts,
                          std::vector<RegionLoad> loads = {}) {
  scenario.rigid = std::move(parts);
  scenario.loads = std::move(loads);
  try {
    make_trunk(scenario);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

RigidPart part(const std::string& region, RigidBody::Motion motion, const std::string& surface_for = "") {
  return {region, motion, {}, surface_for, {"own.toml", 7}};
}

}  // namespace

TEST_CASE("The rib cage is one fixed body of costal insertion, wall and top of the lung", "[unit][anatomy]") {
  const Trunk trunk = make_trunk(without_lung("healthy"));
  REQUIRE(trunk.model.bodies.size() == 1);
  const RigidBody& ribs = trunk.model.bodies[0];
  CHECK(ribs.name == "rib_cage");
  CHECK(ribs.motion == RigidBody::Motion::fixed);
  std::set<int> expected;
  for (const char* region : {"costal_insertion", "lung_wall", "lung_top"})
    expected.insert(trunk.mesh.named(region).begin(), trunk.mesh.named(region).end());
  CHECK(std::set<int>(ribs.particles.begin(), ribs.particles.end()) == expected);
  CHECK(ribs.particles.size() == 33);
  CHECK(trunk.model.supports.size() == 24);
}

TEST_CASE("Without ribs there is no body and no surface", "[unit][anatomy]") {
  Scenario scenario = without_lung("healthy");
  scenario.tissue.ribs = false;
  const Trunk trunk = make_trunk(scenario);
  CHECK(trunk.model.bodies.empty());
  CHECK(trunk.model.supports.empty());
}

TEST_CASE("A rigid part takes its particles and its surface from the rib cage", "[unit][anatomy]") {
  Scenario scenario = without_lung("healthy");
  scenario.rigid = {swinging_half(scenario, "right", 3.0)};
  const Trunk trunk = make_trunk(scenario);
  REQUIRE(trunk.model.bodies.size() == 2);
  const auto &half = trunk.model.bodies[0], &rest = trunk.model.bodies[1];
  CHECK(half.name == "rib_cage_right");
  CHECK(half.particles == trunk.mesh.named("rib_cage_right"));
  CHECK(rest.name == "rib_cage");
  CHECK(half.particles.size() + rest.particles.size() == 33);
  for (int i : half.particles) CHECK(trunk.model.rest[at(i)].x() > 0.0);
  const auto& zone = trunk.mesh.named("zone_of_apposition_right");
  REQUIRE(trunk.model.supports.size() == 24);
  for (const Support& s : trunk.model.supports)
    CHECK(s.body == (std::find(zone.begin(), zone.end(), s.particle) != zone.end() ? 0 : 1));

  scenario.tissue.ribs = false;  // then this part is the only one
  const Trunk alone = make_trunk(scenario);
  CHECK(alone.model.bodies.size() == 1);
  CHECK(alone.model.supports.size() == zone.size());
}

TEST_CASE("If both halves of the rib cage swing outward, volume and ribs hold and the breath is deeper",
          "[property][anatomy][slow]") {
  Scenario scenario = without_lung("healthy");
  const double without = run_breath(make_trunk(scenario), scenario, 0).measures.delta_v;
  scenario.rigid = {swinging_half(scenario, "right", 3.0), swinging_half(scenario, "left", 3.0)};
  const Trunk trunk = make_trunk(scenario);
  const Held held = held_over(scenario, trunk);
  CHECK(held.ending.completed());
  CHECK(held.volume_error < 1e-10);
  CHECK(held.farthest_outside < 1e-9);
  CHECK(held.farthest_outside > -1e-3);  // some supports touch

  const BreathRun run = run_breath(trunk, scenario, 0);
  WARN("halves at 3 degrees: delta V " << 1e6 * run.measures.delta_v << " ml, without " << 1e6 * without
                                       << " ml, volume error " << held.volume_error << ", farthest outside "
                                       << held.farthest_outside << " m");
  CHECK(run.measures.delta_v > without + 50e-6);
  CHECK(run.measures.excursion_right == Approx(run.measures.excursion_left).epsilon(0.01));
  const auto& costal = trunk.mesh.named("costal_insertion");
  const auto rightmost = at(*std::max_element(costal.begin(), costal.end(), [&](int a, int b) {
    return trunk.model.rest[at(a)].x() < trunk.model.rest[at(b)].x();
  }));
  CHECK(run.end_inspiration[rightmost].x() > trunk.model.rest[rightmost].x() + 5e-3);  // it moves outward

  // Every particle moves as its mirror image does, to 1 % of the largest motion.
  double largest_motion = 0.0, worst = 0.0;
  for (std::size_t i = 0; i < trunk.model.particles(); ++i)
    for (std::size_t j = 0; j < trunk.model.particles(); ++j) {
      const auto mirrored = [](const Vec3d& p) { return Vec3d{-p.x(), p.y(), p.z()}; };
      if (norm(mirrored(trunk.model.rest[i]) - trunk.model.rest[j]) > 1e-9) continue;
      largest_motion = std::max(largest_motion, norm(run.end_inspiration[i] - trunk.model.rest[i]));
      worst = std::max(worst, norm(mirrored(run.end_inspiration[i]) - run.end_inspiration[j]));
    }
  CHECK(largest_motion > 5e-3);
  CHECK(worst < 0.01 * largest_motion);
}

TEST_CASE("Halves that swing inward make the breath shallower and come back to their place",
          "[property][anatomy][slow]") {
  Scenario scenario = without_lung("healthy");
  const double without = run_breath(make_trunk(scenario), scenario, 0).measures.delta_v;
  scenario.rigid = {swinging_half(scenario, "right", -2.0), swinging_half(scenario, "left", -2.0)};
  const Trunk trunk = make_trunk(scenario);
  const Held held = held_over(scenario, trunk);
  CHECK(held.ending.completed());
  CHECK(held.volume_error < 1e-10);
  CHECK(held.farthest_outside < 1e-9);
  CHECK(run_breath(trunk, scenario, 0).measures.delta_v < without - 50e-6);
  const BreathRun run = run_breath(trunk, scenario, 4500);
  for (int i : trunk.mesh.named("rib_cage_right"))
    CHECK(norm(run.frames.back().position[at(i)] - trunk.model.rest[at(i)]) < 1e-12);
}

TEST_CASE("A free tendon without ribs moves as one piece, and the volume holds", "[property][anatomy]") {
  Scenario scenario = without_lung("published_healthy");
  scenario.reaction = Reaction::variational;
  scenario.time.duration_s = 2.5;
  scenario.rigid = {part("central_tendon", RigidBody::Motion::free)};
  const Trunk trunk = make_trunk(scenario);
  REQUIRE(trunk.model.bodies.size() == 1);
  const BreathRun run = run_breath(trunk, scenario, 100);
  REQUIRE(run.ending.completed());
  CHECK(run.max_relative_volume_error < 1e-13);
  const auto& tendon = trunk.mesh.named("central_tendon");
  double stretch = 0.0, moved = 0.0;
  for (const auto& frame : run.frames)
    for (int a : tendon)
      for (int b : tendon) {
        const double apart = norm(frame.position[at(a)] - frame.position[at(b)]);
        stretch =
            std::max(stretch, std::abs(apart - norm(trunk.model.rest[at(a)] - trunk.model.rest[at(b)])));
        moved = std::max(moved, norm(frame.position[at(a)] - trunk.model.rest[at(a)]));
      }
  CHECK(stretch < 1e-13);
  CHECK(moved > 1e-3);
  CHECK(run.measures.delta_v > 50e-6);
}

TEST_CASE("Impossible rigid parts are refused with their place", "[unit][anatomy]") {
  using enum RigidBody::Motion;
  const Scenario healthy = without_lung("healthy");
  const auto refused = [&](std::vector<RigidPart> parts, const std::string& what,
                           std::vector<RegionLoad> loads = {}) {
    const std::string message = message_about(healthy, std::move(parts), std::move(loads));
    INFO(message);
    CHECK(message.starts_with("own.toml:7: "));
    CHECK_THAT(message, Contains(what));
    CHECK(message.find("own.toml", 5) == std::string::npos);  // the place is there once
  };
  refused({part("rib_cage_right", fixed), part("lung_wall", fixed)}, "two rigid bodies");
  refused({part("sternum", fixed)}, "'sternum'");
  refused({part("sternum", fixed)}, "rib_cage_right");  // names what there is
  refused({part("lung_wall", fixed, "sternum")}, "'sternum'");
  refused({part("0-113", free)}, "0-113");
  refused({part("dome_saddle", free)}, "on a line");
  refused({part("lung_wall", fixed, "central_tendon")}, "cannot slide");
  refused({part("lung_wall", fixed, "costal_insertion")}, "cannot slide");
  refused({part("lung_wall", free, "zone_of_apposition")}, "free");
  refused({part("lung_wall", fixed, "apposition_top"), part("lung_top", fixed, "zone_of_apposition")},
          "already slides");
  RegionLoad pull;
  pull.kind = RegionLoad::Kind::displacement;
  pull.region = "central_tendon";
  pull.direction = pull.axes = {0, 0, 1};
  pull.magnitude = PiecewiseLinear({{0.0, 0.001}});
  pull.at = {"own.toml", 7};
  refused({part("central_tendon", free)}, "moving rigid part", {pull});
  CHECK(message_about(healthy, {}, {pull}) == "no error");
  CHECK(message_about(healthy, {part("central_tendon", fixed)}, {pull}) == "no error");
}

TEST_CASE("A zone of apposition whose muscle lines coincide has no rib surface and is refused",
          "[regression][anatomy]") {
  TrunkMesh mesh = mesh_of(Scenario{});
  const auto &left = mesh.muscle_lines[2], &right = mesh.muscle_lines[0];  // on both sides of line 1
  for (std::size_t row = 0; row < left.size(); ++row) mesh.rest[at(left[row])] = mesh.rest[at(right[row])];
  CHECK_THROWS_AS(make_trunk(mesh, {}, Reaction::variational), InputError);

  TrunkMesh twice = mesh_of(Scenario{});
  twice.muscle_lines[2] = twice.muscle_lines[0];
  CHECK_THROWS_WITH(make_trunk(twice, {}, Reaction::variational), Contains("on two muscle lines"));
}

TEST_CASE("A trunk in other axes, or with another order of its lines, is refused", "[regression][anatomy]") {
  const auto message = [](auto change) {
    TrunkMesh mesh = mesh_of(Scenario{});
    change(mesh);
    try {
      make_trunk(mesh, {}, Reaction::variational);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  const auto turned = [&](auto turn) {
    return message([&](TrunkMesh& mesh) {
      for (Vec3d& p : mesh.rest) p = turn(p);
    });
  };
  CHECK_THAT(turned([](const Vec3d& p) { return Vec3d{-p.x(), -p.y(), p.z()}; }), Contains("right"));  // LPS
  CHECK_THAT(turned([](const Vec3d& p) {
               return Vec3d{p.x(), -p.z(), p.y()};
             }),
             Contains("above each other"));
  CHECK_THAT(turned([](const Vec3d& p) { return Vec3d{p.y(), p.x(), p.z()}; }), Contains("expected x"));
  CHECK(turned([](const Vec3d& p) { return p + Vec3d{0.3, 0.1, -2.0}; }) == "no error");
  CHECK_THAT(message([](TrunkMesh& mesh) {
               auto& line = mesh.muscle_lines[4];
               std::reverse(line.begin(), line.end());
             }),
             Contains("costal_insertion"));
  CHECK_THAT(message([](TrunkMesh& mesh) { mesh.regions.erase("zone_of_apposition"); }),
             Contains("'zone_of_apposition'"));
}

TEST_CASE("The side of a particle depends on the trunk's own midline", "[regression][anatomy]") {
  Tissue tissue;
  tissue.paralysed = Side::right;
  const TrunkMesh mesh = mesh_of(Scenario{});
  const Trunk before = make_trunk(mesh, tissue, Reaction::variational);
  TrunkMesh shifted = mesh;
  for (Vec3d& p : shifted.rest) p += Vec3d{0.3, 0.0, 0.0};
  shifted.rest[at(shifted.named("dome_saddle").front())] += Vec3d{1e-12, 0.0, 0.0};
  const Trunk after = make_trunk(shifted, tissue, Reaction::variational);
  for (std::size_t f = 0; f < before.model.fibres.size(); ++f)
    CHECK(after.model.fibres[f].activity == Approx(before.model.fibres[f].activity).margin(1e-9));
  for (std::size_t r = 0; r < before.model.shape_memory.rings.size(); ++r)
    CHECK(after.model.shape_memory.stiffness_weight[r] ==
          Approx(before.model.shape_memory.stiffness_weight[r]).margin(1e-8));
}

TEST_CASE("A scenario with an impossible rigid part names file and line once", "[unit][anatomy]") {
  TemporaryFolder folder;
  const auto path = folder.write("bad.toml",
                                 "\n[[rigid]]\nregion = \"rib_cage_left\"\nmotion = \"free\"\n\n"
                                 "[[rigid]]\nregion = \"lung_wall\"\nmotion = \"fixed\"\n");
  try {
    build_trunk(read_scenario(path));
    FAIL("no error");
  } catch (const InputError& error) {
    CHECK_THAT(error.what(), Contains("bad.toml:6: particle") && Contains("two rigid bodies"));
    const std::string message = error.what();
    CHECK(message.find("bad.toml") == message.rfind("bad.toml"));
  }
}
