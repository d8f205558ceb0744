#include <algorithm>
#include <set>

#include "errors/input_error.hpp"
#include "mesh/ring_table.hpp"
#include "support/catch.hpp"
#include "support/zoo.hpp"

using namespace trunk;
using namespace trunk::test;

namespace {

Surface surface_of(std::vector<Triangle> triangles, int particles) {
  return {"skin", std::move(triangles), particles};
}

const std::vector<Triangle> good = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};

std::vector<Triangle> good_but(std::size_t index, Triangle t) {
  std::vector<Triangle> triangles = good;
  triangles[index] = t;
  return triangles;
}

}  // namespace

TEST_CASE("Every mesh of the zoo is a surface", "[unit][mesh]") {
  for (const Mesh& mesh : closed_meshes()) {
    INFO(mesh.name);
    CHECK_NOTHROW(mesh.surface());
    CHECK(mesh.surface().one_rings().size() == mesh.position.size());
  }
  for (std::size_t valence = 3; valence <= 9; ++valence)
    CHECK_FALSE(closed_meshes_with_valence(valence).empty());
}

TEST_CASE("A surface refuses no triangle at all", "[unit][mesh]") {
  CHECK_THROWS_WITH(surface_of({}, 4), Contains("skin") && Contains("no triangle"));
}

TEST_CASE("A surface refuses an open edge and names it", "[unit][mesh]") {
  std::vector<Triangle> open = good;
  open.pop_back();  // leaves the edges 1-2, 2-3 and 3-1 open
  CHECK_THROWS_AS(surface_of(open, 4), InputError);
  CHECK_THROWS_WITH(surface_of(open, 4), Contains("skin") && Contains("closed") &&
                                             (Contains("1-2") || Contains("2-1") || Contains("2-3") ||
                                              Contains("3-2") || Contains("1-3") || Contains("3-1")));
}

TEST_CASE("A surface refuses a triangle turned over and names an edge of it", "[unit][mesh]") {
  CHECK_THROWS_WITH(surface_of(good_but(3, {1, 3, 2}), 4),
                    Contains("skin") && Contains("counter-clockwise") && Contains("edge"));
}

TEST_CASE("A surface refuses an edge with three triangles", "[unit][mesh]") {
  std::vector<Triangle> fin = good;
  fin.push_back({0, 1, 4});
  CHECK_THROWS_WITH(surface_of(fin, 5), Contains("skin") && Contains("0-1"));
}

TEST_CASE("A surface refuses a triangle given twice", "[unit][mesh]") {
  std::vector<Triangle> twice = good;
  twice.push_back(good.front());
  CHECK_THROWS_AS(surface_of(twice, 4), InputError);
}

TEST_CASE("A surface refuses a bow-tie and names its knot", "[unit][mesh]") {
  // Two tetrahedra that share particle 0 alone: closed and manifold at every edge, not at the knot.
  std::vector<Triangle> knot = good;
  for (Triangle t : good) {
    for (int& i : t) i = i == 0 ? 0 : i + 3;
    knot.push_back(t);
  }
  CHECK_THROWS_WITH(surface_of(knot, 7), Contains("skin") && Contains("particle 0") && Contains("fan"));
}

TEST_CASE("A surface refuses particles that do not exist and names them", "[unit][mesh]") {
  CHECK_THROWS_WITH(surface_of(good_but(3, {1, 2, 4}), 4), Contains("particle 4") && Contains("0 to 3"));
  CHECK_THROWS_WITH(surface_of(good_but(3, {1, 2, -1}), 4), Contains("particle -1"));
}

TEST_CASE("A surface refuses a triangle that repeats a particle", "[unit][mesh]") {
  CHECK_THROWS_WITH(surface_of(good_but(3, {1, 2, 2}), 4), Contains("(1 2 2)") && Contains("repeats"));
  CHECK_THROWS_AS(surface_of(good_but(3, {1, 1, 3}), 4), InputError);
  CHECK_THROWS_AS(surface_of(good_but(3, {1, 2, 1}), 4), InputError);
}

TEST_CASE("One-rings run counter-clockwise and hold every triangle of their particle once",
          "[property][mesh]") {
  for (const Mesh& mesh : closed_meshes()) {
    INFO(mesh.name);
    std::set<Triangle> directed;  // each triangle, starting at each of its corners
    for (const auto& [a, b, c] : mesh.triangles) directed.insert({{a, b, c}, {b, c, a}, {c, a, b}});
    std::size_t corners = 0;
    const Surface surface = mesh.surface();
    for (const auto& [vertex, ring] : surface.one_rings()) {
      for (std::size_t j = 0; j < ring.size(); ++j)
        REQUIRE(directed.contains({vertex, ring[j], ring[(j + 1) % ring.size()]}));
      REQUIRE(std::set<int>(ring.begin(), ring.end()).size() == ring.size());
      corners += ring.size();
    }
    CHECK(corners == 3 * mesh.triangles.size());
    CHECK(std::is_sorted(surface.one_rings().begin(), surface.one_rings().end(),
                         [](const auto& a, const auto& b) { return a.vertex < b.vertex; }));
  }
}

TEST_CASE("The ring table visits every one-ring once, whole and in order", "[property][mesh]") {
  for (const Mesh& mesh : closed_meshes()) {
    INFO(mesh.name);
    const Surface surface = mesh.surface();
    const RingTable table = ring_table(surface);
    std::set<std::size_t> seen;
    std::size_t expected_row = 0;
    for_each_ring(table, [&](std::size_t row, std::size_t vertex, auto neighbours) {
      CHECK(row == expected_row++);
      CHECK(seen.insert(vertex).second);
      const auto ring = std::find_if(surface.one_rings().begin(), surface.one_rings().end(),
                                     [&](const auto& r) { return r.vertex == static_cast<int>(vertex); });
      REQUIRE(ring != surface.one_rings().end());
      CHECK(std::equal(neighbours.begin(), neighbours.end(), ring->neighbours.begin(), ring->neighbours.end(),
                       [](Neighbour n, int particle) { return n.particle() == particle; }));
    });
    CHECK(seen.size() == surface.one_rings().size());
  }
}

TEST_CASE("A ring table contains its rings from any beginning, and no others", "[unit][mesh]") {
  for (const Mesh& mesh : closed_meshes()) {
    INFO(mesh.name);
    const Surface surface = mesh.surface();
    const RingTable table = ring_table(surface);
    std::vector<Surface::OneRing> turned(surface.one_rings().begin(), surface.one_rings().end());
    for (auto& [vertex, ring] : turned) std::rotate(ring.begin(), ring.begin() + vertex % 3, ring.end());
    CHECK(contains(table, ring_table(turned)));
    std::vector<Surface::OneRing> fewer(turned.begin() + 1, turned.end());
    CHECK(contains(table, ring_table(fewer)));
    CHECK_FALSE(contains(ring_table(fewer), table));
    std::reverse(turned[0].neighbours.begin(), turned[0].neighbours.end());
    CHECK_FALSE(contains(table, ring_table(turned)));
  }
}
