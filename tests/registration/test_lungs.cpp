#include "registration/lungs.hpp"

#include <numbers>

#include "errors/input_error.hpp"
#include "math/units.hpp"
#include "registration/surface_samples.hpp"
#include "support/catch.hpp"
#include "support/zoo.hpp"

using namespace trunk;
using namespace trunk::test;

namespace {

/// A closed body, 100 mm wide, 150 mm deep and 200 mm high, with its middle at x.
MeasuredSurface body_at(double x) {
  const Mesh ball = icosphere(1.0, 4);
  MeasuredSurface surface{"body", {}, ball.triangles};
  for (const Vec3d& p : ball.position)
    surface.points.push_back(hadamard(p, Vec3d(0.05, 0.075, 0.1)) + Vec3d(x, 0.0, 0.0));
  return surface;
}

double largest_inward(const MeasuredSurface& s) {
  double largest = -1.0;
  for (const Triangle& t : s.triangles) {
    const Vec3d n = unit_normal(s.points, t), at = s.points[static_cast<std::size_t>(t[0])];
    if (n.z() > -0.5) largest = std::max(largest, (at.x() < 0.0 ? 1.0 : -1.0) * n.x());
  }
  return largest;
}

}  // namespace

TEST_CASE("Of two lungs the sides that face each other are left out", "[unit][registration]") {
  const MeasuredSurface both = joined({body_at(0.08), body_at(-0.08)});
  const LungSurface found = outer_lungs(both);
  CHECK(found.two_bodies);
  CHECK(found.side == LungSide::both);
  CHECK(found.gap == Approx(60 * m_per_mm).margin(8 * m_per_mm));
  CHECK(5 * found.outer.triangles.size() < 4 * both.triangles.size());
  CHECK(2 * found.outer.triangles.size() > both.triangles.size());
  CHECK(largest_inward(found.outer) <= 0.5);
  CHECK(found.volume == Approx(2 * 4.0 / 3.0 * std::numbers::pi * 0.05 * 0.075 * 0.1).epsilon(0.02));
}

TEST_CASE("One body as wide as both lungs stays whole", "[unit][registration]") {
  MeasuredSurface wide = body_at(0.0);
  for (Vec3d& p : wide.points) p = hadamard(p, Vec3d(3.0, 1.0, 1.0));
  const LungSurface found = outer_lungs(wide);
  CHECK_FALSE(found.two_bodies);
  CHECK(found.side == LungSide::both);
  CHECK(found.outer.triangles == wide.triangles);
  CHECK(found.notes.empty());
}

TEST_CASE("Which lung it is, is seen from a flat side and a leaning top, or has to be said",
          "[unit][registration]") {
  for (const double outward : {1.0, -1.0}) {
    MeasuredSurface lung = body_at(0.0);
    for (Vec3d& p : lung.points)  // flatter inside, and leaning inward above
      p = {outward * ((p.x() < 0.0 ? 0.6 : 1.0) * p.x() - 0.1 * std::max(p.z(), 0.0)), p.y(), p.z()};
    const LungSurface found = outer_lungs(lung);
    CHECK(found.side == (outward > 0.0 ? LungSide::right : LungSide::left));
    REQUIRE_FALSE(found.notes.empty());
    CHECK(outward * found.middle ==
          Approx(-60 * m_per_mm).margin(15 * m_per_mm));  // 30 mm beyond its inner side
  }
  CHECK_THROWS_WITH(outer_lungs(body_at(0.0)), Contains("does not say which one") && Contains("--lung-side"));
  CHECK(outer_lungs(body_at(0.0), LungSide::left).side == LungSide::left);
}

TEST_CASE("A thin tube half-way between the lungs is left out", "[unit][registration]") {
  const Mesh tube_ball = icosphere(1.0, 3);
  MeasuredSurface tube{"tube", {}, tube_ball.triangles};
  for (const Vec3d& p : tube_ball.position)
    tube.points.push_back(hadamard(p, Vec3d(0.06, 0.008, 0.008)) + Vec3d(0.0, -0.02, 0.02));
  const MeasuredSurface lungs = joined({body_at(0.08), body_at(-0.08)});
  const MeasuredSurface with_tube = joined({body_at(0.08), body_at(-0.08), tube});
  const LungSurface found = outer_lungs(with_tube);
  CHECK(found.two_bodies);
  for (const Triangle& t : found.outer.triangles)
    CHECK(std::abs(found.outer.points[static_cast<std::size_t>(t[0])].x()) > 0.02);
  CHECK(found.volume == Approx(outer_lungs(lungs).volume).epsilon(0.06));
}

TEST_CASE("Bodies that show no axes give none", "[unit][registration]") {
  CHECK_FALSE(guess_axes_of_lungs(joined({body_at(0.08), body_at(-0.08)})));
  CHECK_FALSE(guess_axes_of_lungs(body_at(0.0)));
}
