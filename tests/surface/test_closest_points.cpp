#include <algorithm>

#include "errors/input_error.hpp"
#include "support/catch.hpp"
#include "support/zoo.hpp"
#include "surface/distances.hpp"
#include "surface/signed_distance.hpp"

using namespace trunk;
using namespace trunk::test;

namespace {

struct Soup {
  std::vector<Vec3d> points;
  std::vector<Triangle> triangles;
};

/// Returns triangles at random places. Some of them are a point or a line.
Soup random_soup(std::size_t size, Random& random) {
  Soup soup;
  for (std::size_t i = 0; i < size; ++i) {
    const auto first = static_cast<int>(soup.points.size());
    const Vec3d at = random.vector(1.0), a = random.vector(0.3), b = random.vector(0.3);
    soup.points.insert(soup.points.end(), {at, at + a, at + b, at + 1e-9 * b, at + 0.5 * a});
    const Triangle shapes[] = {{0, 1, 2}, {0, 1, 4}, {0, 2, 3}, {0, 0, 1}, {2, 2, 2}};
    Triangle t = shapes[random.below(5)];
    for (int& corner : t) corner += first;
    soup.triangles.push_back(t);
  }
  return soup;
}

/// Returns the closest distance by a search over weights, first coarse and then fine. It shares nothing with
/// the code under test.
double searched_distance(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& p) {
  double best = HUGE_VAL, best_v = 0.0, best_w = 0.0;
  for (double step = 0.1; step > 1e-9; step *= 0.25) {
    const double v0 = best_v, w0 = best_w;
    const int reach = step == 0.1 ? 10 : 5;
    for (int i = -reach; i <= reach; ++i)
      for (int j = -reach; j <= reach; ++j) {
        const double v = std::clamp(v0 + i * step, 0.0, 1.0), w = std::clamp(w0 + j * step, 0.0, 1.0 - v);
        const double d = norm(p - ((1.0 - v - w) * a + v * b + w * c));
        if (d < best) {
          best = d;
          best_v = v;
          best_w = w;
        }
      }
  }
  return best;
}

}  // namespace

TEST_CASE("The closest point is that of an exhaustive search, also on degenerate triangles",
          "[unit][surface]") {
  Random random(1);
  const Soup soup = random_soup(40, random);
  const ClosestPoints closest(soup.points, soup.triangles);
  for (int i = 0; i < 20; ++i) {
    const Vec3d p = random.vector(1.5);
    double searched = HUGE_VAL;
    for (const Triangle& t : soup.triangles) {
      const auto at = [&](std::size_t k) { return soup.points[static_cast<std::size_t>(t[k])]; };
      searched = std::min(searched, searched_distance(at(0), at(1), at(2), p));
    }
    CHECK(closest(p).distance == Approx(searched).epsilon(1e-6));
  }
}

TEST_CASE("The tree finds the same point as a search through all triangles", "[unit][surface]") {
  Random random(2);
  const Soup soup = random_soup(500, random);
  const ClosestPoints closest(soup.points, soup.triangles);
  std::vector<ClosestPoints> each;
  for (const Triangle& t : soup.triangles) each.emplace_back(soup.points, std::span(&t, 1));
  for (int i = 0; i < 300; ++i) {
    const Vec3d p = random.vector(1.5);
    double least = HUGE_VAL;
    for (const ClosestPoints& one : each) least = std::min(least, one(p).distance);
    const ClosestPoints::Hit hit = closest(p);
    CHECK(hit.distance == least);
    const Triangle& t = soup.triangles.at(static_cast<std::size_t>(hit.triangle));
    Vec3d point;
    for (std::size_t k = 0; k < 3; ++k) {
      CHECK((hit.weight[k] >= 0.0 && hit.weight[k] <= 1.0));
      point += hit.weight[k] * soup.points[static_cast<std::size_t>(t[k])];
    }
    CHECK(norm(point - hit.point) < 1e-15);
    CHECK(norm(p - hit.point) == Approx(hit.distance));
  }
}

TEST_CASE("A surface without triangles, or with corners that do not exist, is refused", "[unit][surface]") {
  const std::vector<Vec3d> points(3);
  CHECK_THROWS_WITH(ClosestPoints(points, {}), Contains("without triangles"));
  const std::vector<Triangle> beyond{{0, 1, 3}}, negative{{0, -1, 2}};
  CHECK_THROWS_AS(ClosestPoints(points, beyond), InputError);
  CHECK_THROWS_AS(ClosestPoints(points, negative), InputError);
}

TEST_CASE("The sign of a distance is negative inside and positive outside", "[unit][surface]") {
  Random random(3);
  const Mesh ball = icosphere(0.1, 2);
  const SignedDistance to_ball(ball.position, ball.triangles);
  const SignedDistance to_box(box(0.2, 0.2, 0.2).position, box(0.2, 0.2, 0.2).triangles);
  for (int i = 0; i < 2000; ++i) {
    const Vec3d p = random.vector(0.2);
    if (norm(p) > 0.1) CHECK(to_ball(p).side > 0.0);
    if (norm(p) < 0.09) CHECK(to_ball(p).side < 0.0);
    CHECK(std::abs(to_ball(p).side) == to_ball(p).distance);
    const double x = std::max({std::abs(p.x()), std::abs(p.y()), std::abs(p.z())});
    if (std::abs(x - 0.1) > 1e-9) CHECK((to_box(p).side > 0.0) == (x > 0.1));
  }
}

TEST_CASE("Beside a sharp edge the sign is not that of the nearest face by chance", "[unit][surface]") {
  // The edges of a tetrahedron are sharper than a right angle: a point beyond one lies behind one of its
  // faces.
  Random random(4);
  const Mesh sharp = tetrahedron(0.1);
  const SignedDistance to_sharp(sharp.position, sharp.triangles);
  for (int i = 0; i < 2000; ++i) {
    const Vec3d p = random.vector(0.15);
    bool inside = true;
    for (const Triangle& t : sharp.triangles) {
      const auto at = [&](std::size_t k) { return sharp.position[static_cast<std::size_t>(t[k])]; };
      inside = inside && dot(cross(at(1) - at(0), at(2) - at(0)), p - at(0)) < 0.0;
    }
    CHECK((to_sharp(p).side < 0.0) == inside);
  }
}

TEST_CASE("Points are spread evenly over the area for any triangles", "[unit][surface]") {
  // A square cut into one large triangle and a fan of small ones.
  const Soup square{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.1, 0.5, 0}, {0.3, 0.4, 0}},
                    {{0, 1, 2}, {0, 2, 5}, {0, 5, 4}, {5, 2, 4}, {4, 2, 3}, {0, 4, 3}, {3, 3, 3}}};
  const std::vector<Vec3d> spread = spread_over(square.points, square.triangles, 10000);
  REQUIRE(spread.size() == 10000);
  int counts[4][4] = {};
  for (const Vec3d& p : spread) {
    REQUIRE((p.x() >= 0 && p.x() <= 1 && p.y() >= 0 && p.y() <= 1));
    ++counts[std::min(3, static_cast<int>(4 * p.x()))][std::min(3, static_cast<int>(4 * p.y()))];
  }
  for (const auto& row : counts)
    for (const int found : row) CHECK(std::abs(found - 625) < 30);
  CHECK(spread_over(square.points, std::span(square.triangles).last(1), 100).empty());
}

TEST_CASE("Distances between spheres are the differences of their radii", "[unit][surface]") {
  const Mesh inner = icosphere(0.10, 4), outer = icosphere(0.11, 4);
  const ClosestPoints to(outer.position, outer.triangles);
  const Distances d = distances(inner.position, inner.triangles, to, 2000);
  for (const double value : {d.mean, d.rms, d.median, d.percentile95, d.hausdorff})
    CHECK(value == Approx(0.01).margin(2e-4));
  CHECK(d.hausdorff >= d.percentile95);
  const Distances known = statistics_of({3.0, 1.0, 2.0, 0.0, 4.0});
  CHECK(known.mean == 2.0);
  CHECK(known.rms == Approx(std::sqrt(6.0)));
  CHECK(known.median == 2.0);
  CHECK(known.percentile95 == Approx(3.8));
  CHECK(known.hausdorff == 4.0);
}

TEST_CASE("The largest distance counts a corner that no sample hits", "[unit][surface]") {
  const std::vector<Vec3d> spike{{0, 0, 0}, {1, 0, 0}, {0.5, 0, 5}};
  const std::vector<Vec3d> plane{{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}};
  const std::vector<Triangle> one{{0, 1, 2}};
  CHECK(distances(spike, one, ClosestPoints(plane, one), 10).hausdorff == Approx(5.0));
}
