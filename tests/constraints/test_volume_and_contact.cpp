#include "constraints/volume_and_contact.hpp"

#include <cmath>

#include "support/catch.hpp"
#include "support/trunks.hpp"

using namespace trunk;
using namespace trunk::test;

namespace {

/// One projection of a model away from rest: its input and its result.
struct Projected {
  const Model& model;
  State<double> state = rest_state<double>(model);
  Workspace<double> w = make_workspace(model, Parameters<double>{4000.0, 30.0, 20.0}, 1e-3);
  std::vector<Vec3d> predicted;
  Projection<double> result{};

  Projected(const Model& m, const std::vector<Vec3d>& x, double fraction) : model(m), predicted(x) {
    project(fraction);
  }
  void project(double fraction) {
    w.next = predicted;
    calc_planes(model, state, w);
    calc_ring_areas<double>(model.abdomen.rings, state.position, w.reactions.area);
    result = project_volume_and_supports(model, fraction * model.abdomen.rest, state, w);
  }
  double volume_error(double fraction) const {
    return std::abs(
        enclosed_volume<double>(model.abdomen.triangles, w.next) / (fraction * model.abdomen.rest) - 1.0);
  }
  Vec3d correction(const Support& s) const {
    const auto i = static_cast<std::size_t>(s.particle);
    return w.next[i] - predicted[i];
  }
  /// Beyond the plane that stands for the rib surface in this step; the surface itself is in
  /// test_contact.cpp.
  double depth(std::size_t s) const {
    const auto& plane = w.plane[s];
    const auto i = static_cast<std::size_t>(model.supports[s].particle);
    return dot(plane.normal, w.next[i] - plane.predicted) + plane.excess;
  }
};

/// Returns positions as an integrator predicts them: held particles stay.
std::vector<Vec3d> predicted(const Model& model, double size, Random& random) {
  std::vector<Vec3d> x = model.rest;
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += scaled(model.mobility[i], random.vector(size));
  return x;
}

}  // namespace

TEST_CASE("Without supports the volume is restored to round-off", "[property][constraints]") {
  Random random(51);
  Tissue no_ribs;
  no_ribs.ribs = false;
  const Trunk trunk = make_template_trunk({}, no_ribs, Reaction::variational);
  double worst = 0.0;
  for (const double size : {1e-5, 1e-3, 5e-3, 15e-3})
    for (int i = 0; i < 25; ++i) {
      const double fraction = i % 2 == 0 ? 1.0 : random.between(0.97, 1.03);
      const Projected p(trunk.model, predicted(trunk.model, size, random), fraction);
      CAPTURE(size, fraction, p.volume_error(fraction));
      REQUIRE(p.result.found);
      REQUIRE(p.volume_error(fraction) < 2e-15);
      worst = std::max(worst, p.volume_error(fraction));
    }
  WARN("largest relative volume error without supports: " << worst);
}

TEST_CASE("Held particles and held axes stay where they are", "[property][constraints]") {
  Random random(52);
  Trunk trunk = make_template_trunk({}, {}, Reaction::variational);
  const auto dome = static_cast<std::size_t>(trunk.mesh.named("dome_saddle").front());
  trunk.model.mobility[dome] = {1.0, 0.0, 1.0};
  const auto x = predicted(trunk.model, 5e-3, random);
  const Projected p(trunk.model, x, 1.01);
  REQUIRE(p.result.found);
  int held = 0;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (dot(trunk.model.mobility[i], trunk.model.mobility[i]) == 0.0) {
      ++held;
      CHECK(norm(p.w.next[i] - x[i]) == 0.0);
    }
  CHECK(held > 40);
  CHECK(p.w.next[dome].y() == x[dome].y());
  CHECK(p.w.next[dome].z() != x[dome].z());
}

TEST_CASE("The correction is along the volume gradient over the effective mass", "[unit][constraints]") {
  // One particle ten times heavier moves that much less than its gradient says.
  const Mesh mesh = icosphere(0.1, 1);
  Model model = free_body(mesh, Reaction::variational, 0.2);
  hold_volume(mesh, model);
  model.mass[3] = 2.0;
  const Projected p(model, mesh.position, 1.02);
  REQUIRE(p.result.found);
  for (const int vertex : model.abdomen.rings.vertex) {
    const auto i = static_cast<std::size_t>(vertex);
    const double effective_mass = model.mass[i] + 1e-3 * 20.0;
    const Vec3d expected = (p.result.multiplier / 6.0 / effective_mass) * p.w.reactions.area[i];
    CHECK(norm(p.w.next[i] - mesh.position[i] - expected) < 1e-13);
  }
  CHECK(p.result.multiplier > 0.0);  // a larger volume needs a positive pressure
}

TEST_CASE("A volume whose surface is not elastic is held like one without stiffness", "[unit][constraints]") {
  Random random(58);
  const Mesh mesh = icosphere(0.1, 1);
  Model elastic = free_body(mesh, Reaction::variational, 0.2);
  hold_volume(mesh, elastic);
  Model slack = elastic;
  slack.shape_memory = {};
  const Parameters<double> without_stiffness{0.0, 0.0, 5.0};
  std::vector<State<double>> ends;
  const std::vector<Vec3d> kicked = deformed(mesh.position, 2e-4, random);
  for (const Model* model : {&elastic, &slack}) {
    State<double> state = rest_state<double>(*model);
    state.previous = kicked;
    Workspace<double> w = make_workspace(*model, without_stiffness, 1e-3);
    CHECK(w.elastic_volume == (model == &elastic));
    for (int n = 0; n < 50; ++n) REQUIRE(step(*model, without_stiffness, 0.0, state, w).ok);
    CHECK(std::abs(enclosed_volume<double>(mesh.triangles, state.position) / model->abdomen.rest - 1.0) <
          1e-14);
    ends.push_back(state);
  }
  for (std::size_t i = 0; i < mesh.position.size(); ++i) {
    CHECK(norm(ends[0].position[i] - ends[1].position[i]) < 1e-14);
    CHECK(norm(ends[0].position[i] - mesh.position[i]) > 1e-6);
  }
}

TEST_CASE("With supports the volume is exact, and no particle penetrates or is pulled",
          "[property][constraints]") {
  Random random(53);
  const Trunk trunk = make_template_trunk({}, {}, Reaction::variational);
  REQUIRE(trunk.model.supports.size() == 24);
  double deepest = -1.0, worst = 0.0;
  int touching = 0, apart = 0, not_found = 0;
  for (const double size : {1e-5, 1e-3, 5e-3, 15e-3})
    for (int i = 0; i < 50; ++i) {
      const double fraction = i % 2 == 0 ? 1.0 : random.between(0.98, 1.02);
      const Projected p(trunk.model, predicted(trunk.model, size, random), fraction);
      CAPTURE(size, i, fraction, p.result.multiplier);
      if (!p.result.found) {
        ++not_found;
        continue;
      }
      REQUIRE(p.volume_error(fraction) < 1e-14);
      worst = std::max(worst, p.volume_error(fraction));
      for (std::size_t s = 0; s < trunk.model.supports.size(); ++s) {
        const Support& support = trunk.model.supports[s];
        const double depth = p.depth(s);
        const Vec3d normal = (1.0 / norm(p.w.plane[s].normal)) * p.w.plane[s].normal;
        deepest = std::max(deepest, depth);
        REQUIRE(depth < 1e-15);
        const Vec3d unsupported = p.result.multiplier * p.w.plane[s].direction;
        const Vec3d push = p.correction(support) - unsupported;
        // Complementarity: either on the plane and pushed inward, or free of it and not pushed at all.
        if (p.state.contact[s].touching) {
          ++touching;
          REQUIRE(std::abs(depth) < 1e-15);
          REQUIRE(dot(push, normal) < 1e-15);
          REQUIRE(norm(push - dot(push, normal) * normal) < 1e-15);
        } else {
          ++apart;
          REQUIRE(norm(push) < 1e-15);
        }
      }
    }
  CHECK(touching > 500);
  CHECK(apart > 500);
  CHECK(not_found == 0);
  WARN("with supports: deepest penetration " << deepest << " m, largest relative volume error " << worst
                                             << ", " << touching << " touching, " << apart << " apart");
}

TEST_CASE("The volume correction itself can end or begin a contact", "[property][constraints]") {
  // At rest every particle of the zone lies on its plane. Less volume pulls all of them off, more presses
  // them on.
  const Trunk trunk = make_template_trunk({}, {}, Reaction::variational);
  const auto touching = [&](double fraction) {
    const Projected p(trunk.model, trunk.model.rest, fraction);
    REQUIRE(p.result.found);
    return std::count_if(p.state.contact.begin(), p.state.contact.end(),
                         [](const auto& c) { return c.touching; });
  };
  CHECK(touching(0.99) == 0);
  CHECK(touching(1.01) == 24);
}

TEST_CASE("Supports that touch without force do not keep the search from ending", "[property][constraints]") {
  // Round-off about rest: each support may or may not touch, and every choice gives the volume to round-off.
  Random random(55);
  const Trunk trunk = make_template_trunk({}, {}, Reaction::variational);
  int lost = 0;
  for (const double size : {1e-19, 1e-18, 1e-17, 1e-16, 1e-15, 1e-14, 1e-13})
    for (int i = 0; i < 200; ++i) {
      Projected p(trunk.model, predicted(trunk.model, size, random), 1.0);
      for (auto& contact : p.state.contact) contact.touching = random.unit() < 0.5;
      p.project(1.0);
      lost += !p.result.found || p.volume_error(1.0) > 1e-14;
    }
  CHECK(lost == 0);
}

TEST_CASE("Contacts of the step before do not change the solution", "[property][constraints]") {
  Random random(54);
  const Trunk trunk = make_template_trunk({}, {}, Reaction::variational);
  const auto x = predicted(trunk.model, 3e-3, random);
  Projected p(trunk.model, x, 1.0);
  for (int start = 0; start < 20; ++start) {
    for (auto& contact : p.state.contact) contact.touching = random.unit() < 0.5;
    p.project(1.0);
    CAPTURE(start);
    REQUIRE(p.result.found);
    REQUIRE(p.volume_error(1.0) < 1e-14);
    for (std::size_t s = 0; s < trunk.model.supports.size(); ++s) REQUIRE(p.depth(s) < 1e-15);
  }
}

TEST_CASE("A volume out of reach is reported", "[unit][constraints]") {
  const Trunk trunk = make_template_trunk({}, {}, Reaction::variational);
  Model held = trunk.model;
  for (Vec3d& m : held.mobility) m = Vec3d{0, 0, 0};
  CHECK_FALSE(Projected(held, held.rest, 1.01).result.found);

  std::vector<Vec3d> broken = trunk.model.rest;
  broken[60] = {std::nan(""), 0, 0};
  CHECK_FALSE(Projected(trunk.model, broken, 1.0).result.found);
  CHECK_FALSE(Projected(trunk.model, trunk.model.rest, std::nan("")).result.found);
}
