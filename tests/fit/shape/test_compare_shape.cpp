#include <cmath>

#include "errors/input_error.hpp"
#include "shape/compare_shape.hpp"
#include "support/catch.hpp"

using namespace trunk;

namespace {

/// A flat square with sides of 0.1 m in the plane z, from x = `left` on; it faces up.
MeasuredSurface measured_square(double left, double z) {
  const double right = left + 0.1;
  return {"square", {{left, 0, z}, {right, 0, z}, {right, 0.1, z}, {left, 0.1, z}}, {{0, 1, 2}, {0, 2, 3}}};
}

/// A run of two frames: a plate of 0.1 m that rises from z = 0 to z = 0.02 m within 2 s, and a lung, a
/// tetrahedron on the corners 4 to 7 that is larger in the first frame. Particle 4 belongs to no triangle of
/// the plate, so the plate's numbers and the run's differ.
Trajectory plate_run() {
  Trajectory t;
  t.particles = 8;
  t.time_s = {0.0, 2.0};
  for (const double part : {0.0, 1.0}) {
    const double z = 0.02 * part, size = 0.1 - 0.05 * part;
    t.position_m.insert(t.position_m.end(), {0, 0, 1, size, 0, 1, 0, size, 1, 0, 0, 1 + size});
    t.position_m.insert(t.position_m.end(), {0, 0, z, 0.1, 0, z, 0.1, 0.1, z, 0, 0.1, z});
  }
  t.region = {1, 1, 1, 1, 0, 0, 0, 0};
  t.region_names = {"plate", "lung_wall"};
  t.triangles = {{4, 5, 6}, {4, 6, 7}, {0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  t.triangle_component = {0, 0, 1, 1, 1, 1};
  t.component_names = {"abdomen_and_diaphragm", "lung"};
  return t;
}

}  // namespace

TEST_CASE("A region has the particles and positions of its triangles at a time between frames", "[shape]") {
  const RunRegion plate = region_at("plate", 0.5, plate_run(), "r.h5");
  CHECK(plate.particles == std::vector<int>{4, 5, 6, 7});
  CHECK(plate.particles_of_run == 8);
  CHECK(plate.triangles == std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}});
  for (const Vec3d& p : plate.points) CHECK(p.z() == Approx(0.005));
  CHECK(region_at("lung", 0.0, plate_run(), "r.h5").particles == std::vector<int>{0, 1, 2, 3});
}

TEST_CASE("A moment is a word or a time of the trajectory", "[shape]") {
  const Trajectory t = plate_run();
  CHECK(moment_of("start", t, "r.h5") == 0.0);
  CHECK(moment_of("end", t, "r.h5") == 2.0);
  CHECK(moment_of("peak", t, "r.h5") == 0.0);  // the lung shrinks
  CHECK(moment_of("1.25", t, "r.h5") == 1.25);
  for (const char* wrong : {"2.5", "-1", "noon", "1 s", "nan", ""})
    CHECK_THROWS_WITH(moment_of(wrong, t, "r.h5"),
                      Contains("r.h5: there is no moment '" + std::string(wrong) + "'; expected peak, ") &&
                          Contains("0 to 2 s"));
  CHECK_THROWS_WITH(region_at("liver", 0.0, t, "r.h5"),
                    Contains("region 'liver' has no triangle; expected diaphragm") && Contains("lung_wall"));
}

TEST_CASE("A trajectory that is missing, damaged or not finite is refused", "[shape]") {
  CHECK_THROWS_WITH(moment_of("end", {}, "r.h5"), Contains("r.h5: has no trajectory; expected"));
  Trajectory damaged = plate_run(), diverged = plate_run();
  damaged.triangles[0][1] = 8;
  CHECK_THROWS_WITH(region_at("plate", 0.0, damaged, "r.h5"), Contains("r.h5: is damaged"));
  diverged.position_m.back() = std::nan("");
  CHECK_THROWS_WITH(region_at("plate", 0.0, diverged, "r.h5"), Contains("r.h5: the run diverged"));
}

TEST_CASE("The distance of a plate to a parallel square is that between their planes, with its side",
          "[shape]") {
  const RunRegion plate = region_at("plate", 2.0, plate_run(), "r.h5");
  for (const double below : {0.015, -0.01}) {
    MeasuredSurface surface = measured_square(0.0, 0.02 - below);
    const ShapeComparison found = compare_shape(plate, surface, false);
    for (const Distances& d : {found.to_surface, found.from_surface}) {
      CHECK(d.mean == Approx(std::abs(below)));
      CHECK(d.rms == Approx(std::abs(below)));
      CHECK(d.hausdorff == Approx(std::abs(below)));
    }
    CHECK(found.mean_side == Approx(below));
    REQUIRE(found.side.size() == 4);
    for (const double side : found.side) CHECK(side == Approx(below));
  }
}

TEST_CASE("Only the part of a region over an open surface counts as covered", "[shape]") {
  const RunRegion plate = region_at("plate", 0.0, plate_run(), "r.h5");
  MeasuredSurface surface = measured_square(-0.06, -0.01);  // it covers the plate up to x = 0.04
  const ShapeComparison found = compare_shape(plate, surface, false);
  CHECK(found.covered == Approx(0.4).margin(0.01));
  CHECK(found.covered_to_surface.hausdorff == Approx(0.01));
  CHECK(found.to_surface.hausdorff == Approx(std::hypot(0.06, 0.01)));
  CHECK(found.at_border[1]);  // the corners at x = 0.1
  CHECK(found.at_border[2]);
  MeasuredSurface beside = measured_square(0.2, 0.0);
  CHECK(compare_shape(plate, beside, false).covered == 0.0);
  CHECK(compare_shape(plate, beside, false).covered_to_surface.mean == 0.0);
}

TEST_CASE("Alignment moves a surface back onto the region and reports the move", "[shape]") {
  const RunRegion plate = region_at("plate", 0.0, plate_run(), "r.h5");
  MeasuredSurface surface = measured_square(0.03, 0.04);
  const ShapeComparison found = compare_shape(plate, surface, true);
  CHECK(found.to_surface.mean < 1e-4);
  CHECK(found.moved.shift.x() == Approx(-0.03).margin(1e-3));
  CHECK(found.moved.shift.z() == Approx(-0.04).margin(1e-3));
  CHECK(surface.points[0].z() == Approx(0.0).margin(1e-4));
}
