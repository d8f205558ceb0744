#include "anatomy/template_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "errors/input_error.hpp"
#include "mesh/volume.hpp"
#include "support/catch.hpp"
#include "support/trunks.hpp"

using namespace trunk;
using namespace trunk::test;

namespace {

TrunkMesh mesh_at(int resolution) {
  TrunkGeometry geometry;
  geometry.resolution = resolution;
  return make_template_mesh(geometry);
}

/// Returns the particle at a place; -1 if there is none.
int particle_at(const TrunkMesh& mesh, const Vec3d& place) {
  for (std::size_t i = 0; i < mesh.rest.size(); ++i)
    if (norm(mesh.rest[i] - place) < 1e-12) return static_cast<int>(i);
  return -1;
}

/// A triangle whatever its first corner: its sense of rotation counts.
Triangle turned(const Triangle& t) {
  const auto least = static_cast<std::size_t>(std::min_element(t.begin(), t.end()) - t.begin());
  return {t[least], t[(least + 1) % 3], t[(least + 2) % 3]};
}

}  // namespace

TEST_CASE("The template has the number of particles of its resolution", "[unit][anatomy]") {
  const std::size_t expected[] = {113, 455, 1029, 1835};
  for (int r = 1; r <= 4; ++r) {
    CAPTURE(r);
    const TrunkMesh mesh = mesh_at(r);
    CHECK(mesh.rest.size() == expected[r - 1]);
    CHECK(mesh.fineness == r);
    // Euler: a sphere of n particles has 2n - 4 triangles.
    for (const auto* surface : {&mesh.abdomen, &mesh.lung}) {
      std::set<int> used;
      for (const Triangle& t : *surface) used.insert(t.begin(), t.end());
      CHECK(surface->size() == 2 * used.size() - 4);
    }
  }
}

TEST_CASE("Both surfaces are closed at every resolution, outward, and without flat triangles",
          "[unit][anatomy]") {
  for (int r = 1; r <= 4; ++r) {
    CAPTURE(r);
    const TrunkMesh mesh = mesh_at(r);
    const int particles = static_cast<int>(mesh.rest.size());
    CHECK_NOTHROW(Surface("abdomen", mesh.abdomen, particles));
    CHECK_NOTHROW(Surface("lung", mesh.lung, particles));
    CHECK(enclosed_volume<double>(mesh.abdomen, mesh.rest) > 0.0);
    double smallest = 1.0;
    for (const auto* surface : {&mesh.abdomen, &mesh.lung})
      for (const Triangle& t : *surface) {
        const Vec3d a = mesh.rest[at(t[0])], b = mesh.rest[at(t[1])], c = mesh.rest[at(t[2])];
        smallest = std::min(smallest, 0.5 * norm(cross(b - a, c - a)) * r * r);
      }
    CHECK(smallest > 1e-4);  // m2 times r^2
  }
}

TEST_CASE("Every resolution is its own mirror image, regions and halves included", "[property][anatomy]") {
  for (int r = 1; r <= 4; ++r) {
    CAPTURE(r);
    const TrunkMesh mesh = mesh_at(r);
    std::vector<int> image;
    for (const Vec3d& p : mesh.rest) image.push_back(particle_at(mesh, {-p.x(), p.y(), p.z()}));
    REQUIRE(std::count(image.begin(), image.end(), -1) == 0);
    for (const auto* surface : {&mesh.abdomen, &mesh.lung}) {
      std::set<Triangle> all;
      for (const Triangle& t : *surface) all.insert(turned(t));
      for (const Triangle& t : *surface)  // a mirror reverses the sense of rotation
        REQUIRE(all.contains(turned({image[at(t[0])], image[at(t[2])], image[at(t[1])]})));
    }
    for (const char* name : {"rib_cage", "zone_of_apposition", "dome_top"}) {
      std::set<int> mirrored, left;
      for (int i : mesh.named(name + std::string("_right"))) mirrored.insert(image[at(i)]);
      for (int i : mesh.named(name + std::string("_left"))) left.insert(i);
      CHECK(left == mirrored);
      CHECK_FALSE(left.empty());
    }
  }
}

TEST_CASE("At every resolution the lung encloses the end-expiratory volume exactly", "[property][anatomy]") {
  for (int r = 1; r <= 4; ++r) {
    TrunkGeometry geometry;
    geometry.resolution = r;
    geometry.dome_height_left = 0.055;
    geometry.end_expiratory_volume = 4321e-6;
    const TrunkMesh mesh = make_template_mesh(geometry);
    CAPTURE(r);
    CHECK(std::abs(enclosed_volume<double>(mesh.lung, mesh.rest) / 4321e-6 - 1.0) < 1e-13);
  }
}

TEST_CASE("Landmarks for measures have the same places at every resolution", "[property][anatomy]") {
  const TrunkMesh coarse = mesh_at(1);
  for (int r = 2; r <= 4; ++r) {
    const TrunkMesh fine = mesh_at(r);
    for (const char* name :
         {"apposition_middle", "apposition_top", "dome_saddle", "dome_top_right", "dome_top_left"}) {
      CAPTURE(r, name);
      const auto &there = fine.named(name), &expected = coarse.named(name);
      REQUIRE(there.size() == expected.size());
      REQUIRE_FALSE(expected.empty());
      for (std::size_t k = 0; k < there.size(); ++k)
        CHECK(norm(fine.rest[at(there[k])] - coarse.rest[at(expected[k])]) < 1e-12);
    }
    const auto& border = fine.named("tendon_border");
    for (int i : coarse.named("tendon_border")) {
      const int same = particle_at(fine, coarse.rest[at(i)]);
      CHECK(std::find(border.begin(), border.end(), same) != border.end());
    }
    // But for the lung, whose height depends on the mesh, every particle of the coarse trunk is in the fine
    // one.
    for (const auto& [region, particles] : coarse.regions)
      if (region != "lung_wall" && region != "lung_top")
        for (int i : particles) CHECK(particle_at(fine, coarse.rest[at(i)]) >= 0);
  }
}

TEST_CASE("At every resolution each particle has one region, and the regions are those of the anatomy",
          "[unit][anatomy]") {
  for (int r = 1; r <= 4; ++r) {
    CAPTURE(r);
    const TrunkMesh mesh = mesh_at(r);
    std::vector<int> times(mesh.rest.size(), 0);
    for (const auto& [name, particles] : mesh.regions)
      for (int i : particles) ++times[at(i)];
    CHECK(std::count(times.begin(), times.end(), 1) == static_cast<long>(times.size()));
    CHECK(mesh.named("costal_insertion").size() == at(12 * r));
    CHECK(mesh.named("spine").size() == at(3 * r));
    CHECK(mesh.named("lung_top").size() == 1);
    CHECK(mesh.regions.size() == (r == 1 ? 7u : 8u));  // finer ones have flanks below the tendon
    const double costal = 0.2, top = 0.2 + 0.149;
    for (int i : mesh.named("zone_of_apposition")) {
      CHECK(mesh.rest[at(i)].z() > costal + 1e-6);
      CHECK(mesh.rest[at(i)].z() < top + 1e-12);
    }
    for (int i : mesh.named("muscular_dome")) CHECK(mesh.rest[at(i)].z() > top + 1e-6);
  }
}

TEST_CASE(
    "Twelve muscle lines times the resolution run from the costal insertion to the border of the tendon",
    "[unit][anatomy]") {
  for (int r = 1; r <= 4; ++r) {
    CAPTURE(r);
    const TrunkMesh mesh = mesh_at(r);
    CHECK_NOTHROW(require_anatomy(mesh));
    REQUIRE(mesh.muscle_lines.size() == at(12 * r));
    CHECK(mesh.apposition_top_row() == at(2 * r));
    std::set<int> first, last;
    for (const auto& line : mesh.muscle_lines) {
      REQUIRE(line.size() == at(3 * r + 1));
      first.insert(line.front());
      last.insert(line.back());
      for (std::size_t row = 1; row < line.size(); ++row)
        CHECK(mesh.rest[at(line[row])].z() > mesh.rest[at(line[row - 1])].z());
    }
    const auto &costal = mesh.named("costal_insertion"), &border = mesh.named("tendon_border");
    CHECK(first == std::set<int>(costal.begin(), costal.end()));
    CHECK(last == std::set<int>(border.begin(), border.end()));
  }
}

TEST_CASE("The abdomen's volume converges with the mesh, to second order", "[property][anatomy]") {
  const auto volume = [](int r) {
    const TrunkMesh mesh = mesh_at(r);
    return enclosed_volume<double>(mesh.abdomen, mesh.rest);
  };
  const double v[] = {volume(2), volume(4), volume(8)};
  const double order = std::log2((v[1] - v[0]) / (v[2] - v[1]));
  WARN("volume of the abdomen at resolution 2, 4, 8: " << 1e6 * v[0] << ", " << 1e6 * v[1] << ", "
                                                       << 1e6 * v[2] << " ml, order " << order);
  CHECK(order == Approx(2.0).margin(0.2));
  CHECK(std::abs(v[2] / v[1] - 1.0) < 0.02);
}

TEST_CASE("A finer mesh lies on a smooth profile, not on the chords of the coarse one", "[unit][anatomy]") {
  const TrunkMesh mesh = mesh_at(2);
  const auto& lines = mesh.muscle_lines;  // at its end: top of the zone, flank, border of the tendon
  for (const auto& line : lines) {
    const auto from_end = [&](std::size_t k) { return mesh.rest[at(line[line.size() - 1 - k])]; };
    const Vec3d border = from_end(0), flank = from_end(1), top = from_end(2);
    CHECK(norm(flank - 0.5 * (border + top)) > 2e-3);
    const double size = norm(flank - Vec3d{0, 0, flank.z()});
    CHECK(size < norm(top - Vec3d{0, 0, top.z()}));  // nothing bulges
    CHECK(size > norm(border - Vec3d{0, 0, border.z()}));
    CHECK(flank.z() > top.z());
    CHECK(flank.z() < border.z());
  }
  for (int i : mesh.named("abdominal_wall")) {  // where the coarse one is a cylinder, so is the fine one
    const Vec3d p = mesh.rest[at(i)];
    CHECK(std::hypot(p.x() / 0.160, p.y() / 0.105) == Approx(1.0).epsilon(1e-12));
  }
}

TEST_CASE("An impossible resolution is refused", "[unit][anatomy]") {
  for (const int r : {-1, 0, 17}) CHECK_THROWS_WITH(mesh_at(r), Contains("expected 1 to 16"));
}
