#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "errors/input_error.hpp"
#include "support/catch.hpp"
#include "support/trunks.hpp"

using namespace trunk;
using namespace trunk::test;

namespace {

Trunk default_trunk(const Tissue& tissue = {}) {
  return make_template_trunk(TrunkGeometry{}, tissue, Reaction::variational);
}

/// Returns the corners of a triangle, sorted.
Triangle sorted(Triangle t) {
  std::sort(t.begin(), t.end());
  return t;
}

std::set<Triangle> set_of(const std::vector<Triangle>& triangles) {
  std::set<Triangle> result;
  for (const Triangle& t : triangles) result.insert(sorted(t));
  return result;
}

/// The particle at the mirror image of each, about x = 0.
std::vector<int> mirror_images(const std::vector<Vec3d>& x) {
  std::vector<int> image(x.size(), -1);
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t j = 0; j < x.size(); ++j)
      if (norm(Vec3d{-x[i].x(), x[i].y(), x[i].z()} - x[j]) < 1e-12) image[i] = static_cast<int>(j);
  return image;
}

double stiffness_weight_of(const Model& model, int particle) {
  const auto& vertex = model.shape_memory.rings.vertex;
  const auto ring = std::find(vertex.begin(), vertex.end(), particle);
  REQUIRE(ring != vertex.end());
  return model.shape_memory.stiffness_weight[static_cast<std::size_t>(ring - vertex.begin())];
}

bool is_held(const Model& model, int i) {
  return dot(model.mobility[at(i)], model.mobility[at(i)]) == 0.0;
}

}  // namespace

TEST_CASE("The template has 113 particles and 232 triangles, 48 of them in both surfaces",
          "[unit][anatomy]") {
  const Trunk trunk = default_trunk();
  CHECK(trunk.model.particles() == 113);
  const auto abdomen = set_of(trunk.mesh.abdomen), lung = set_of(trunk.mesh.lung);
  CHECK(trunk.mesh.abdomen.size() == 180);
  CHECK(abdomen.size() == 180);
  CHECK(trunk.mesh.lung.size() == 100);
  CHECK(lung.size() == 100);
  std::vector<Triangle> shared;
  std::set_intersection(abdomen.begin(), abdomen.end(), lung.begin(), lung.end(), std::back_inserter(shared));
  CHECK(shared.size() == 48);
  CHECK(abdomen.size() + lung.size() - shared.size() == 232);
}

TEST_CASE("The regions have the sizes of the design and every particle has one", "[unit][anatomy]") {
  const Trunk trunk = default_trunk();
  const std::map<std::string, std::size_t> expected{
      {"pelvis", 13},         {"abdominal_wall", 24}, {"costal_insertion", 12}, {"zone_of_apposition", 24},
      {"central_tendon", 19}, {"lung_wall", 20},      {"lung_top", 1}};
  std::set<int> seen;
  for (const auto& [name, particles] : trunk.mesh.regions) {
    INFO(name);
    REQUIRE(expected.contains(name));
    CHECK(particles.size() == expected.at(name));
    seen.insert(particles.begin(), particles.end());
  }
  CHECK(trunk.mesh.regions.size() == expected.size());
  CHECK(seen.size() == 113);
  CHECK(trunk.mesh.named("spine").size() == 3);
}

TEST_CASE("Positions and triangles are mirror images of themselves", "[property][anatomy]") {
  const Trunk trunk = default_trunk();
  const auto image = mirror_images(trunk.model.rest);
  for (int i : image) REQUIRE(i >= 0);
  for (const auto* triangles : {&trunk.mesh.abdomen, &trunk.mesh.lung}) {
    const auto all = set_of(*triangles);
    for (const Triangle& t : *triangles)
      CHECK(all.contains(sorted({image[at(t[0])], image[at(t[1])], image[at(t[2])]})));
  }
}

TEST_CASE("The lung encloses the end-expiratory volume exactly", "[property][anatomy]") {
  for (const double ml : {4000.0, 4760.0, 7000.0}) {
    TrunkGeometry geometry;
    geometry.end_expiratory_volume = ml * 1e-6;
    geometry.dome_height_left = 0.05;
    const Trunk trunk = make_template_trunk(geometry, {}, Reaction::variational);
    const double volume = enclosed_volume<double>(trunk.model.lung, trunk.model.rest);
    CHECK(std::abs(volume / geometry.end_expiratory_volume - 1.0) < 1e-14);
  }
}

TEST_CASE("The template has the given sizes", "[unit][anatomy]") {
  TrunkGeometry g;
  g.dome_height_right = 0.080;
  g.dome_height_left = 0.060;
  const Trunk trunk = make_template_trunk(g, {}, Reaction::variational);
  const Shape shape = shape_of(trunk, trunk.model.rest);
  CHECK(shape.apposition_length == Approx(g.apposition_length).epsilon(1e-12));
  CHECK(shape.half_width == Approx(g.half_width).epsilon(1e-12));
  CHECK(shape.right_dome > shape.left_dome);
  double highest = 0.0;
  for (int i : trunk.mesh.regions.at("central_tendon"))
    highest = std::max(highest, trunk.model.rest[at(i)].z());
  CHECK(highest > g.abdomen_height + g.apposition_length + 0.070);
}

TEST_CASE("The central tendon is twice as stiff as the other diaphragm", "[unit][anatomy]") {
  const Trunk trunk = default_trunk();
  for (int i : trunk.mesh.regions.at("central_tendon")) CHECK(stiffness_weight_of(trunk.model, i) == 2.0);
  for (const char* region : {"zone_of_apposition", "costal_insertion", "abdominal_wall"})
    for (int i : trunk.mesh.regions.at(region)) CHECK(stiffness_weight_of(trunk.model, i) == 1.0);
}

TEST_CASE("Twelve fibres join the costal insertion to their end at the same angle", "[unit][anatomy]") {
  for (const FibreEnd end : {FibreEnd::tendon_border, FibreEnd::apposition_top}) {
    const Trunk trunk = default_trunk(Tissue{.fibre_end = end});
    const auto& end_of =
        trunk.mesh.named(end == FibreEnd::tendon_border ? "tendon_border" : "apposition_top");
    REQUIRE(trunk.model.fibres.size() == 12);
    for (std::size_t k = 0; k < 12; ++k) {
      const Fibre& fibre = trunk.model.fibres[k];
      CHECK(fibre.insertion == trunk.mesh.named("costal_insertion")[k]);
      CHECK(fibre.origin == end_of[k]);
      CHECK(fibre.activity == 1.0);
      const Vec3d a = trunk.model.rest[at(fibre.insertion)], b = trunk.model.rest[at(fibre.origin)];
      CHECK(a.x() * b.y() == Approx(a.y() * b.x()).margin(1e-12));
      CHECK(b.z() > a.z());
    }
  }
}

TEST_CASE("Pelvis, spine and lung are held, the costal insertion with ribs only", "[unit][anatomy]") {
  for (const bool ribs : {true, false}) {
    const Trunk trunk = default_trunk(Tissue{.ribs = ribs});
    std::set<int> expected;
    for (const char* region : {"pelvis", "spine", "lung_wall", "lung_top"})
      expected.insert(trunk.mesh.named(region).begin(), trunk.mesh.named(region).end());
    if (ribs) {
      const auto& costal = trunk.mesh.regions.at("costal_insertion");
      expected.insert(costal.begin(), costal.end());
    }
    for (int i = 0; i < 113; ++i) {
      CAPTURE(ribs, i);
      CHECK(is_held(trunk.model, i) == expected.contains(i));
    }
    CHECK(trunk.model.supports.size() == (ribs ? 24u : 0u));
  }
}

TEST_CASE("The rib surface passes the zone of apposition at rest, tangent and curved as its ellipse",
          "[unit][anatomy]") {
  const Trunk trunk = default_trunk();
  const TrunkGeometry g;
  const double a = g.half_width, b = g.half_depth;
  for (const Support& s : trunk.model.supports) {
    const Vec3d p = trunk.model.rest[at(s.particle)];
    CHECK(norm(s.point - p) == 0.0);
    const Vec3d gradient{p.x() / (a * a), p.y() / (b * b), 0.0};
    CHECK(norm(s.normal - (1.0 / norm(gradient)) * gradient) < 1e-12);
    const Vec3d tangent{-s.normal.y(), s.normal.x(), 0.0};
    const Vec3d bend{dot(s.curvature[0], tangent), dot(s.curvature[1], tangent),
                     dot(s.curvature[2], tangent)};
    const double sine = p.y() / b, cosine = p.x() / a;
    const double exact = a * b / std::pow(a * a * sine * sine + b * b * cosine * cosine, 1.5);
    CHECK(dot(tangent, bend) ==
          Approx(exact).epsilon(0.08));  // of a circle through three of twelve particles
    CHECK(std::abs(dot(s.normal, bend)) < 1e-12);
    CHECK(std::abs(s.curvature[2].z()) < 1e-9);  // straight upward
    CHECK(trunk.model.bodies[at(s.body)].name == "rib_cage");
  }
}

TEST_CASE("Paralysis stills the fibres of its side and softens that half of the diaphragm",
          "[unit][anatomy]") {
  const Trunk trunk = default_trunk(Tissue{.paralysed = Side::right, .paralysed_stiffness = 0.5});
  const auto& rest = trunk.model.rest;
  for (const Fibre& fibre : trunk.model.fibres)
    CHECK(fibre.activity == share_of_side(Side::left, rest[at(fibre.insertion)].x()));
  for (int i : trunk.mesh.regions.at("central_tendon"))
    CHECK(stiffness_weight_of(trunk.model, i) == 2.0 - share_of_side(Side::right, rest[at(i)].x()));
  for (int i : trunk.mesh.regions.at("abdominal_wall")) CHECK(stiffness_weight_of(trunk.model, i) == 1.0);
  const Trunk both = default_trunk(Tissue{.paralysed = Side::both});
  for (const Fibre& fibre : both.model.fibres) CHECK(fibre.activity == 0.0);
}

TEST_CASE("The shares of a particle in both sides sum to one", "[unit][anatomy]") {
  for (const double x : {-0.1, 0.0, 0.1}) {
    CHECK(share_of_side(Side::right, x) + share_of_side(Side::left, x) == 1.0);
    CHECK(share_of_side(Side::both, x) == 1.0);
    CHECK(share_of_side(Side::none, x) == 0.0);
  }
  CHECK(share_of_side(Side::right, 0.1) == 1.0);  // +x is the subject's right
}

TEST_CASE("Damping by area is that of the template, however fine the mesh is", "[property][anatomy]") {
  const auto total_of = [](int resolution, DampingBy share) {
    TrunkGeometry geometry;
    geometry.resolution = resolution;
    const Trunk trunk = make_template_trunk(geometry, Tissue{.damping = share}, Reaction::variational);
    double sum = 0.0, dome = 0.0;
    for (const int i : trunk.model.abdomen.rings.vertex)
      sum += trunk.model.damping_weight[static_cast<std::size_t>(i)];
    for (const int i : trunk.mesh.named("central_tendon"))
      dome += trunk.model.damping_weight[static_cast<std::size_t>(i)];
    return std::pair{sum, dome};
  };
  const auto [particles, dome] = total_of(1, DampingBy::particle);
  CHECK(particles == 92.0);
  CHECK(dome == 19.0);
  const auto [coarse, coarse_dome] = total_of(1, DampingBy::area);
  CHECK(coarse == Approx(92.0).epsilon(1e-3));
  CHECK(std::abs(coarse_dome / dome - 1.0) > 0.05);  // the triangles of the dome are not of the mean size
  // The surface itself changes by a few percent, as its corners are cut less.
  CHECK(total_of(3, DampingBy::area).first == Approx(coarse).epsilon(0.05));
}

TEST_CASE("Impossible sizes are refused", "[unit][anatomy]") {
  const auto make = [](auto change) {
    TrunkGeometry g;
    change(g);
    make_template_trunk(g, {}, Reaction::variational);
  };
  CHECK_THROWS_AS(make([](auto& g) { g.half_width = 0.0; }), InputError);
  CHECK_THROWS_AS(make([](auto& g) { g.half_depth = -0.1; }), InputError);
  CHECK_THROWS_AS(make([](auto& g) { g.abdomen_height = std::nan(""); }), InputError);
  CHECK_THROWS_AS(make([](auto& g) { g.apposition_length = std::numeric_limits<double>::infinity(); }),
                  InputError);
  // A lung too small to fit over its domes: the message gives both heights.
  CHECK_THROWS_WITH(make([](auto& g) { g.end_expiratory_volume = 1000e-6; }),
                    Contains("1000 ml") && Contains("70 mm") && Contains("expected"));
  CHECK_THROWS_AS(default_trunk(Tissue{.particle_mass = 0.0}), InputError);
  CHECK_THROWS_AS(default_trunk(Tissue{.particle_mass = -0.2}), InputError);
  CHECK_THROWS_AS(default_trunk(Tissue{.tendon_factor = -1.0}), InputError);
  CHECK_THROWS_AS(default_trunk(Tissue{.paralysed_stiffness = std::nan("")}), InputError);
}
