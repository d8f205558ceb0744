#include "surface/voxels.hpp"

#include <numbers>

#include "support/catch.hpp"
#include "support/zoo.hpp"

using namespace trunk;
using namespace trunk::test;

namespace {

MeasuredSurface ball_at(double x, double radius) {
  const Mesh ball = icosphere(radius, 3);
  MeasuredSurface surface{"ball", {}, ball.triangles};
  for (const Vec3d& p : ball.position) surface.points.push_back(p + Vec3d(x, 0.0, 0.0));
  return surface;
}

MeasuredSurface two_balls(double x, double radius) {
  MeasuredSurface both = ball_at(-x, radius);
  const MeasuredSurface right = ball_at(x, radius);
  const int before = static_cast<int>(both.points.size());
  both.points.insert(both.points.end(), right.points.begin(), right.points.end());
  for (const Triangle& t : right.triangles)
    both.triangles.push_back({t[0] + before, t[1] + before, t[2] + before});
  return both;
}

std::size_t marked(const Voxels& cells) {
  std::size_t count = 0;
  for (std::size_t c = 0; c < cells.count(); ++c) count += cells[c] != 0;
  return count;
}

double ball_cells(double radius, double edge) {
  return 4.0 / 3.0 * std::numbers::pi * std::pow(radius / edge, 3.0);
}

}  // namespace

TEST_CASE("Cubes fill a closed surface, grow and shrink about roundly", "[unit][surface]") {
  const double radius = 0.06, edge = 0.003;
  const Voxels solid = solid_within(ball_at(0.0, radius));
  CHECK(solid.edge() == edge);
  const auto is = [&](const Voxels& cells, double r) {
    CHECK(static_cast<double>(marked(cells)) == Approx(ball_cells(r, edge)).epsilon(0.12));
  };
  is(solid, radius + 0.5 * edge);
  is(solid.grown(4), radius + 4.5 * edge);
  is(solid.shrunk(4), radius - 3.5 * edge);
  CHECK(marked(solid.shrunk(4).grown(4)) <= marked(solid));
  for (std::size_t c = 0; c < solid.count(); ++c)
    CHECK_FALSE((solid[c] != 0 && norm(solid.centre(c)) > radius + 2 * edge));
}

TEST_CASE("Cubes that touch are one set", "[unit][surface]") {
  std::vector<std::size_t> sizes;
  const Voxels apart = solid_within(two_balls(0.05, 0.04));
  apart.sets(sizes);
  REQUIRE(sizes.size() == 2);
  CHECK(static_cast<double>(sizes[0]) == Approx(static_cast<double>(sizes[1])).epsilon(0.02));
  solid_within(two_balls(0.039, 0.04)).sets(sizes);
  CHECK(sizes.size() == 1);
}

TEST_CASE("A wide surface gets larger cubes", "[unit][surface]") {
  const Voxels wide = solid_within(two_balls(0.95, 0.04));
  CHECK(wide.edge() == Approx(1.98 / 150.0).epsilon(0.01));
  CHECK(wide.count() < 4'000'000);
}
