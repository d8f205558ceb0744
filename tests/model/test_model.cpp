#include "model/model.hpp"

#include <cmath>

#include "errors/input_error.hpp"
#include "support/catch.hpp"
#include "support/trunks.hpp"

using namespace trunk;
using namespace trunk::test;

namespace {

constexpr double width = 0.2, depth = 0.1, tall = 0.15, mass = 0.2;  // m, kg a corner

Model held_box() {
  const Mesh mesh = box(width, depth, tall);
  Model model = free_body(mesh, Reaction::variational, mass);
  hold_volume(mesh, model);
  return model;
}

RigidBody body_of(RigidBody::Motion motion, std::vector<int> particles) {
  RigidBody body;
  body.name = "plate";
  body.motion = motion;
  body.particles = std::move(particles);
  return body;
}

/// The message about a box after one change to it; empty if it is valid.
template <class Change>
std::string message_after(Change&& change) {
  Model model = held_box();
  change(model);
  try {
    require_valid(model);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

const double not_a_number = std::nan("");

}  // namespace

TEST_CASE("A model without a mistake is valid", "[unit][model]") {
  CHECK(message_after([](Model&) {}) == "");
  CHECK(message_after([](Model& m) {
          m.fibres.push_back({0, 7, 0.0});
          m.membrane.push_back({0, 1, 0.1, 0.0});
          m.focal_forces.push_back({7, {0, 0, 1}, {}});
          m.imposed_displacements.push_back({0, {1, 0, 0}, {1, 0, 0}, {}});
          m.pressures.push_back({{{0, 1, 2}}, {}});
          carry(body_of(RigidBody::Motion::fixed, {0}), m);
          m.supports.push_back({5, 0, {}, {0, 0, 1}, {}});
        }) == "");
}

TEST_CASE("Particles that cannot be simulated are refused with their number", "[unit][model]") {
  CHECK_THAT(message_after([](Model& m) { m.rest.clear(); }), Contains("no particle"));
  CHECK_THAT(message_after([](Model& m) { m.mass.pop_back(); }), Contains("8 positions, 7 masses"));
  CHECK_THAT(message_after([](Model& m) { m.mobility.pop_back(); }), Contains("7 mobilities"));
  CHECK_THAT(message_after([](Model& m) {
               m.rest[3] = {0, not_a_number, 0};
             }),
             Contains("particle 3") && Contains("not finite"));
  for (const double bad : {0.0, -0.1, not_a_number, HUGE_VAL})
    CHECK_THAT(message_after([&](Model& m) { m.mass[4] = bad; }),
               Contains("particle 4 has a mass of") && Contains("; expected more than 0"));
  for (const double bad : {-0.1, not_a_number, HUGE_VAL})
    CHECK_THAT(message_after([&](Model& m) { m.damping_weight[2] = bad; }),
               Contains("particle 2 has a damping weight of") && Contains("; expected 0 or more"));
}

TEST_CASE("A shape memory that is incomplete or has no frame is refused", "[unit][model]") {
  CHECK_THAT(message_after([](Model& m) { m.shape_memory.rest_offset.pop_back(); }),
             Contains("differ in length"));
  CHECK_THAT(message_after([](Model& m) { m.shape_memory.abdominal_share.pop_back(); }),
             Contains("differ in length"));
  CHECK_THAT(message_after([](Model& m) {
               m.shape_memory.rest_offset[0] = {not_a_number, 0, 0};
             }),
             Contains("no local frame"));
  CHECK_THAT(message_after([](Model& m) { m.shape_memory.stiffness_weight[0] = -1.0; }),
             Contains("stiffness factor of -1"));
}

TEST_CASE("Loads, fibres and springs on particles that do not exist are refused", "[unit][model]") {
  CHECK_THAT(message_after([](Model& m) { m.fibres.push_back({0, 8, 1.0}); }), Contains("fibre 0-8"));
  CHECK_THAT(message_after([](Model& m) { m.fibres.push_back({-1, 0, 1.0}); }), Contains("fibre -1-0"));
  CHECK_THAT(message_after([](Model& m) { m.fibres.push_back({2, 2, 1.0}); }), Contains("fibre 2-2"));
  CHECK_THAT(message_after([](Model& m) {
               m.fibres.push_back({0, 1, -0.5});
             }),
             Contains("an activity of -0.5"));
  CHECK_THAT(message_after([](Model& m) { m.membrane.push_back({0, 8, 0.1, 1.0}); }), Contains("0-8"));
  CHECK_THAT(message_after([](Model& m) {
               m.membrane.push_back({0, 1, 0.0, 1.0});
             }),
             Contains("a length of 0 m"));
  CHECK_THAT(message_after([](Model& m) {
               m.pressures.push_back({{{0, 1, 8}}, {}});
             }),
             Contains("a pressure acts"));
  CHECK_THAT(message_after([](Model& m) {
               m.focal_forces.push_back({8, {0, 0, 1}, {}});
             }),
             Contains("a force acts on particle 8"));
  CHECK_THAT(message_after([](Model& m) {
               m.imposed_displacements.push_back({-1, {}, {}, {}});
             }),
             Contains("a displacement acts on particle -1"));
}

TEST_CASE("Supports need a body that is there and not free", "[unit][model]") {
  CHECK_THAT(message_after([](Model& m) {
               m.supports.push_back({5, 0, {}, {0, 0, 1}, {}});
             }),
             Contains("particle 5 is supported"));
  CHECK_THAT(message_after([](Model& m) {
               carry(body_of(RigidBody::Motion::free, {0, 1, 2}), m);
               m.supports.push_back({5, 0, {}, {0, 0, 1}, {}});
             }),
             Contains("is free"));
  CHECK_THAT(message_after([](Model& m) {
               carry(body_of(RigidBody::Motion::fixed, {0}), m);
               m.supports.push_back({5, 0, {}, {0, not_a_number, 1}, {}});
             }),
             Contains("no direction"));
  CHECK_THAT(message_after([](Model& m) { m.friction = -0.1; }), Contains("friction coefficient is -0.1"));
}

TEST_CASE("Surfaces that enclose no volume are refused", "[unit][model]") {
  CHECK_THAT(message_after([](Model& m) { m.abdomen.rest = 0.0; }),
             Contains("abdominal compartment encloses 0 ml"));
  CHECK_THAT(message_after([](Model& m) {
               for (Triangle& t : m.lung) std::swap(t[1], t[2]);
               m.lung_fans = fans(m.lung);
             }),
             Contains("the lung encloses -3000 ml"));
}

TEST_CASE("A free body has the mass, centre and inertia of its particles", "[unit][model]") {
  Model model = held_box();
  carry(body_of(RigidBody::Motion::free, {0, 1, 2, 3, 4, 5, 6, 7}), model);
  const RigidBody& body = model.bodies.front();
  const double total = 8 * mass;
  CHECK(body.mass == Approx(total));
  CHECK(body.damping_weight == Approx(8.0));
  CHECK(norm(body.centre) < 1e-15);
  const double inertia[] = {total * (depth * depth + tall * tall) / 4,
                            total * (width * width + tall * tall) / 4,
                            total * (width * width + depth * depth) / 4};
  CHECK(norm(body.inverse_inertia[0] - Vec3d{1 / inertia[0], 0, 0}) < 1e-12 / inertia[0]);
  CHECK(norm(body.inverse_inertia[1] - Vec3d{0, 1 / inertia[1], 0}) < 1e-12 / inertia[0]);
  CHECK(norm(body.inverse_inertia[2] - Vec3d{0, 0, 1 / inertia[2]}) < 1e-12 / inertia[0]);
  CHECK(body.held_rows.size() == 8);
  for (const Vec3d& free_axes : model.mobility) CHECK(norm(free_axes) == 0.0);
}

TEST_CASE("The heavier particles draw the centre of a free body", "[unit][model]") {
  Model model = held_box();
  model.mass[0] = 5 * mass;
  carry(body_of(RigidBody::Motion::free, {0, 1, 2}), model);
  const RigidBody& body = model.bodies.front();
  CHECK(body.mass == Approx(7 * mass));
  CHECK(norm(7.0 * body.centre - (5.0 * model.rest[0] + model.rest[1] + model.rest[2])) < 1e-15);
  CHECK(body.held_rows.size() == 3);
  for (const int row : body.held_rows) CHECK(model.abdomen.rings.vertex[at(row)] <= 2);
}

TEST_CASE("A driven body turns about the point of its axis and holds no rows", "[unit][model]") {
  Model model = held_box();
  RigidBody body = body_of(RigidBody::Motion::driven, {0, 1, 2});
  body.imposed.point = {0.3, 0.2, 0.1};
  carry(body, model);
  CHECK(norm(model.bodies.front().centre - Vec3d{0.3, 0.2, 0.1}) == 0.0);
  CHECK(model.bodies.front().held_rows.empty());
  for (std::size_t i = 0; i < 8; ++i) CHECK(norm(model.mobility[i]) == (i < 3 ? 0.0 : norm(Vec3d{1, 1, 1})));
}

TEST_CASE("A body that cannot be carried is refused", "[unit][model]") {
  using enum RigidBody::Motion;
  Model model = held_box();
  CHECK_NOTHROW(carry(body_of(fixed, {}), model));  // the rib cage, where other parts claim all of it
  for (const auto motion : {driven, free})
    CHECK_THROWS_WITH(carry(body_of(motion, {}), model), Contains("'plate' carries no particle"));
  CHECK_THROWS_WITH(carry(body_of(fixed, {8}), model), Contains("particle 8, which does not exist"));
  CHECK_THROWS_WITH(carry(body_of(fixed, {-1}), model), Contains("particle -1, which does not exist"));
  CHECK_THROWS_WITH(carry(body_of(free, {0, 1}), model), Contains("lie on a line"));
  carry(body_of(fixed, {3}), model);
  CHECK_THROWS_WITH(carry(body_of(fixed, {3}), model), Contains("two rigid bodies"));
  CHECK(model.bodies.size() == 2);  // refused bodies leave the model as it was
}

TEST_CASE("Forces move free bodies and free axes; loads and driven bodies move their own", "[unit][model]") {
  Model model = held_box();
  for (const std::size_t i : {4UL, 5UL, 6UL, 7UL}) model.mobility[i] = {0, 0, 0};
  model.mobility[4] = {0, 0, 1};
  carry(body_of(RigidBody::Motion::free, {0, 1, 2}), model);
  carry(body_of(RigidBody::Motion::driven, {3}), model);
  model.imposed_displacements.push_back({5, {1, 0, 0}, {1, 0, 0}, {}});
  CHECK(pushed_particles(model) == std::vector<bool>{true, true, true, false, true, false, false, false});
  CHECK(moving_particles(model) == std::vector<bool>{true, true, true, true, true, true, false, false});
}

TEST_CASE("Ranges hold the numbers for which a mask is true", "[unit][model]") {
  const auto numbers = [](const std::vector<bool>& mask) {
    std::vector<std::size_t> all;
    for_all(ranges(mask), [&](std::size_t i) { all.push_back(i); });
    return all;
  };
  CHECK(numbers({}).empty());
  CHECK(numbers({false, false}).empty());
  CHECK(numbers({true, true, false, true}) == std::vector<std::size_t>{0, 1, 3});
  CHECK(ranges({true, true, false, true}).size() == 2);
}

TEST_CASE("Fans are parted by whether something moves one of their particles", "[unit][model]") {
  Model model = held_box();
  for (Vec3d& free_axes : model.mobility) free_axes = {0, 0, 0};
  CHECK(by_motion(model.lung_fans, model).moving.size() == 0);
  model.mobility[0] = {0, 0, 1};
  const MovingAndStill parts = by_motion(model.lung_fans, model);
  CHECK(parts.moving.size() > 0);
  CHECK(parts.moving.size() + parts.still.size() == model.lung_fans.size());
  CHECK(volume_of_fans<double>(parts.moving, model.rest) + volume_of_fans<double>(parts.still, model.rest) ==
        Approx(width * depth * tall));
}
