#include <cmath>
#include <numbers>

#include "mesh/fans.hpp"
#include "support/catch.hpp"
#include "support/trunks.hpp"

using namespace trunk;
using namespace trunk::test;

namespace {

double volume_of(const Mesh& mesh) {
  return enclosed_volume<double>(mesh.triangles, mesh.position);
}

/// [particles]
std::vector<Vec3d> gradient_of(const Mesh& mesh) {
  const RingTable rings = ring_table(mesh.surface());
  std::vector<Vec3d> gradient(mesh.position.size());
  calc_ring_areas<double>(rings, mesh.position, gradient);
  for (Vec3d& g : gradient) g = (1.0 / 6.0) * g;
  return gradient;
}

Vec3d central_difference(const Mesh& mesh, std::size_t i, double h) {
  const auto along = [&](const Vec3d& step) {
    Mesh moved = mesh;
    moved.position[i] += step;
    const double ahead = volume_of(moved);
    moved.position[i] -= step + step;
    return (ahead - volume_of(moved)) / (2.0 * h);
  };
  return {along({h, 0, 0}), along({0, h, 0}), along({0, 0, h})};
}

}  // namespace

TEST_CASE("The enclosed volume equals the closed forms", "[unit][mesh]") {
  CHECK(volume_of(tetrahedron(0.3)) == Approx(0.027 / (6.0 * std::sqrt(2.0))).epsilon(1e-14));
  CHECK(volume_of(box(0.2, 0.3, 0.5)) == Approx(0.03).epsilon(1e-14));
  CHECK(volume_of(octahedron(0.1)) == Approx(4.0 / 3.0 * 1e-3).epsilon(1e-14));
  CHECK(volume_of(two_tetrahedra()) == Approx(2.0 * volume_of(tetrahedron(0.1))).epsilon(1e-13));
}

TEST_CASE("The enclosed volume of finer spheres converges with order 2", "[property][mesh]") {
  const double exact = 4.0 / 3.0 * std::numbers::pi * 1e-3;
  double last = 0.0;
  for (int level = 1; level <= 4; ++level) {
    const double error = 1.0 - volume_of(icosphere(0.1, level)) / exact;
    const double order = std::log2(last / error);
    CAPTURE(level, error, order);
    CHECK(error > 0.0);  // inscribed
    if (level > 1) CHECK(order == Approx(2.0).margin(0.1));
    last = error;
  }
  CHECK(last < 4e-3);
}

TEST_CASE("A surface turned inside out encloses minus its volume", "[unit][mesh]") {
  Mesh mesh = star();
  const double volume = volume_of(mesh);
  REQUIRE(volume > 0.0);
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  CHECK(volume_of(mesh) == Approx(-volume).epsilon(1e-14));
}

TEST_CASE("The enclosed volume does not change under rigid motion", "[property][mesh]") {
  Random random(11);
  for (Mesh mesh : closed_meshes()) {
    INFO(mesh.name);
    const double volume = volume_of(mesh);
    const RigidMotion motion = random_motion(random);
    for (Vec3d& p : mesh.position) p = motion(p);
    CHECK(volume_of(mesh) == Approx(volume).epsilon(1e-10));
  }
}

TEST_CASE("The volume gradient equals central differences", "[property][mesh]") {
  Random random(12);
  double worst = 0.0;
  for (Mesh mesh : closed_meshes()) {
    INFO(mesh.name);
    mesh.position = deformed(mesh.position, 0.02, random);
    const std::vector<Vec3d> gradient = gradient_of(mesh);
    const double scale = largest(gradient);
    REQUIRE(scale > 1e-4);
    for (std::size_t i = 0; i < gradient.size(); ++i) {
      const double error = norm(gradient[i] - central_difference(mesh, i, 1e-4)) / scale;
      worst = std::max(worst, error);
      REQUIRE(error < 1e-10);  // exact but for round-off: the volume is linear in each particle
    }
  }
  CAPTURE(worst);
  CHECK(worst < 1e-10);
}

TEST_CASE("Volume gradients sum to zero and carry no moment", "[property][mesh]") {
  // The volume does not change when the whole surface moves or turns.
  Random random(13);
  for (Mesh mesh : closed_meshes()) {
    INFO(mesh.name);
    mesh.position = deformed(mesh.position, 0.02, random);
    const std::vector<Vec3d> gradient = gradient_of(mesh);
    const double scale = largest(gradient);
    CHECK(norm(total(gradient)) < 1e-14 * scale * static_cast<double>(gradient.size()));
    CHECK(norm(total_moment(mesh.position, gradient)) < 1e-14 * scale * static_cast<double>(gradient.size()));
  }
}

TEST_CASE("The volume gradient gives three times the volume along the position", "[property][mesh]") {
  // Euler's theorem on homogeneous functions, which the constraint relies on.
  for (const Mesh& mesh : closed_meshes()) {
    INFO(mesh.name);
    const std::vector<Vec3d> gradient = gradient_of(mesh);
    double sum = 0.0;
    for (std::size_t i = 0; i < gradient.size(); ++i) sum += dot(gradient[i], mesh.position[i]);
    CHECK(sum == Approx(3.0 * volume_of(mesh)).epsilon(1e-12));
  }
}

TEST_CASE("Fans take every triangle once, and their volume is that of the triangles", "[property][mesh]") {
  Random random(14);
  for (Mesh mesh : closed_meshes()) {
    INFO(mesh.name);
    mesh.position = deformed(mesh.position, 0.02, random);
    const RingTable table = fans(mesh.triangles);
    CHECK(table.size() <= mesh.triangles.size() / 2);
    CHECK(volume_of_fans<double>(table, mesh.position) == Approx(volume_of(mesh)).epsilon(1e-12));
    // Any part of a surface, whose volume depends on where the origin is.
    std::vector<Triangle> part;
    for (const Triangle& t : mesh.triangles)
      if (random.unit() < 0.6) part.push_back(t);
    CHECK(volume_of_fans<double>(fans(part), mesh.position) ==
          Approx(enclosed_volume<double>(part, mesh.position)).epsilon(1e-10).margin(1e-10));
  }
  CHECK(fans({}).size() == 0);
}

TEST_CASE("The area along moving corners is the area at their new places", "[unit][mesh]") {
  Random random(15);
  for (const std::size_t corners : {4U, 6U, 8U}) {
    std::vector<Vec3d> n, d;
    for (std::size_t i = 0; i < corners; ++i) {
      n.push_back(random.vector(1.0));
      d.push_back(random.vector(1.0));
    }
    const AreaAlong<double> area = twice_area_along<double>(n, d);
    for (const double lambda : {-2.0, 0.0, 0.5, 3.0}) {
      std::vector<Vec3d> moved = n;
      for (std::size_t i = 0; i < corners; ++i) moved[i] += lambda * d[i];
      const Vec3d found = area.at + lambda * area.change + (lambda * lambda) * area.along;
      CHECK(norm(found - twice_area<double>(moved)) < 1e-13 * (1.0 + lambda * lambda));
    }
  }
}
