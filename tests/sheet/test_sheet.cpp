#include "sheet/sheet.hpp"

#include <cmath>
#include <functional>

#include "dynamics/stability.hpp"
#include "forces/shape_memory.hpp"
#include "linear_algebra/decompositions.hpp"
#include "mesh/areas.hpp"
#include "support/catch.hpp"
#include "support/trunks.hpp"

using namespace trunk;
using namespace trunk::test;

namespace {

constexpr double one_sheet = 1.0;  // N/m, k_elasticity

/// Two flat sheets of the same pattern, joined along their border. The tests look at the upper one, in which
/// particle (i, j) has the number i + columns j.
struct Pillow {
  int columns = 0, rows = 0;
  std::vector<Vec3d> position;
  std::vector<Triangle> triangles;

  int top(int i, int j) const { return i + columns * j; }
  bool on_edge(int i, int j) const { return i == 0 || j == 0 || i == columns - 1 || j == rows - 1; }
};

/// Returns whether the cell right and forward of particle (i, j) has its diagonal from there, or else the
/// other.
using Diagonal = std::function<bool(int i, int j)>;

/// `slide`: how far row j is ahead of row 0, over dx.
Pillow pillow(int columns, int rows, double dx, double dy, const std::function<double(int)>& slide,
              const Diagonal& diagonal) {
  Pillow p{columns, rows, {}, {}};
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) p.position.push_back({dx * (i + slide(j)), dy * j, 0.0});
  std::vector<int> bottom;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      bottom.push_back(p.on_edge(i, j) ? p.top(i, j) : static_cast<int>(p.position.size()));
      if (!p.on_edge(i, j)) p.position.push_back(p.position[at(p.top(i, j))] - Vec3d{0, 0, 2.0 * dx});
    }
  const auto add = [&](int a, int b, int c) {
    p.triangles.push_back({a, b, c});
    p.triangles.push_back({bottom[at(c)], bottom[at(b)], bottom[at(a)]});
  };
  for (int j = 0; j + 1 < rows; ++j)
    for (int i = 0; i + 1 < columns; ++i) {
      const int a = p.top(i, j), b = p.top(i + 1, j), c = p.top(i + 1, j + 1), d = p.top(i, j + 1);
      const bool corner = (i == 0 || i + 2 == columns) && (j == 0 || j + 2 == rows);
      const bool forward = corner ? (i == 0) == (j == 0) : diagonal(i, j);  // no triangle is in both sheets
      if (forward) {
        add(a, b, c);
        add(a, c, d);
      } else {
        add(a, b, d);
        add(b, c, d);
      }
    }
  return p;
}

ShapeMemory memory_of(const Pillow& p) {
  const std::vector<double> one(p.position.size(), 1.0), none(p.position.size(), 0.0);
  const Surface surface("pillow", p.triangles, static_cast<int>(p.position.size()));
  return make_shape_memory(surface, p.position, one, none, Reaction::variational);
}

/// The stiffness of these rings, and 0 elsewhere.
std::vector<double> only(const ShapeMemory& memory, const std::vector<int>& vertices) {
  std::vector<double> stiffness(memory.rings.size(), 0.0);
  for (std::size_t r = 0; r < stiffness.size(); ++r)
    for (const int v : vertices)
      if (memory.rings.vertex[r] == v) stiffness[r] = one_sheet * memory.stiffness_weight[r];
  return stiffness;
}

/// The energies of the particles in the middle of the sheet, bent by the curvatures xx and yy and the twist
/// xy, over 1/2 D (xx + yy)^2 times their areas; the smallest and the largest.
std::pair<double, double> bending(const Pillow& p, const ShapeMemory& memory, double xx, double xy,
                                  double yy) {
  const double small = 1e-3;  // 1/m
  std::vector<Vec3d> bent = p.position;
  for (Vec3d& x : bent)
    x += Vec3d{0, 0, small * (0.5 * xx * x.x() * x.x() + xy * x.x() * x.y() + 0.5 * yy * x.y() * x.y())};
  const std::vector<double> area = particle_areas(p.triangles, p.position);
  const double curvature = small * (xx + yy);
  double least = 1e9, most = 0.0;
  for (int j = 4; j < 8; ++j)
    for (int i = 4; i < 8; ++i) {
      const int v = p.top(i, j);
      const double energy = shape_memory_energy(memory, only(memory, {v}), bent);
      const double ratio =
          energy / (0.5 * bending_stiffness(one_sheet) * curvature * curvature * area[at(v)]);
      least = std::min(least, ratio);
      most = std::max(most, ratio);
    }
  return {least, most};
}

/// The same over cylinders whose axes point in all directions.
std::pair<double, double> bending_all_ways(const Pillow& p, const ShapeMemory& memory) {
  double least = 1e9, most = 0.0;
  for (const double degrees : {0.0, 25.0, 45.0, 90.0, 120.0, 135.0}) {
    const double c = std::cos(degrees * 0.017453292519943295), s = std::sin(degrees * 0.017453292519943295);
    const auto [low, high] = bending(p, memory, c * c, c * s, s * s);
    least = std::min(least, low);
    most = std::max(most, high);
  }
  return {least, most};
}

double no_slide(int) {
  return 0.0;
}
double half_slide(int row) {
  return 0.5 * (row % 2);
}
bool every_other(int i, int j) {
  return (i + j) % 2 == 0;
}
bool one_way(int, int) {
  return true;
}
/// The diagonal that makes equilateral triangles of rows that slide by halves.
bool with_slide(int, int j) {
  return j % 2 == 1;
}

struct Pattern {
  const char* name;
  Pillow p;
  double least, most;  // of the energy of a cylinder over that of a plate
};

}  // namespace

TEST_CASE("Flat patterns bend like a plate, in any direction", "[property][sheet]") {
  const double h = 0.02;
  for (const Pattern& pattern :
       {Pattern{"equilateral", pillow(12, 12, h, h * std::sqrt(0.75), half_slide, with_slide), 0.999, 1.001},
        Pattern{"squares, diagonals by turns", pillow(12, 12, h, h, no_slide, every_other), 0.999, 1.001},
        Pattern{"twice as wide, by turns", pillow(12, 12, 2 * h, h, no_slide, every_other), 0.95, 1.05},
        Pattern{"squares, one way", pillow(12, 12, h, h, no_slide, one_way), 0.8, 1.25},
        Pattern{"twice as wide, one way", pillow(12, 12, 2 * h, h, no_slide, one_way), 0.75, 1.3}}) {
    ShapeMemory memory = memory_of(pattern.p);
    lay_sheet(pattern.p.triangles, pattern.p.position, memory);
    const auto [least, most] = bending_all_ways(pattern.p, memory);
    CAPTURE(pattern.name, least, most);
    CHECK(least > pattern.least);
    CHECK(most < pattern.most);
    const auto [low, high] = bending(pattern.p, memory, 1.0, 0.0, 1.0);
    CHECK(low == Approx(1.0).epsilon(1e-4));
    CHECK(high == Approx(1.0).epsilon(1e-4));
  }
}

TEST_CASE("Without the weights, the same patterns do not", "[property][sheet]") {
  // This guards the test above. The second moments of these rings are as 1 to 4.
  const Pillow wide = pillow(12, 12, 0.04, 0.02, no_slide, every_other);
  ShapeMemory memory = memory_of(wide);
  lay_sheet(wide.triangles, wide.position, memory);
  memory.extra_weight.assign(memory.extra_weight.size(), 0.0);
  const double along = bending(wide, memory, 1.0, 0.0, 0.0).first,
               across = bending(wide, memory, 0.0, 0.0, 1.0).first;
  CAPTURE(along, across);
  CHECK(along > 4.0 * across);
}

TEST_CASE("A clamped beam approaches that of the textbook with the square of the spacing",
          "[property][sheet]") {
  // Under an even load q a beam of length L that is clamped at both ends takes the volume q L^5 / (720 D) a
  // width. The second differences of three intervals, with borders that see one side, take 1.975 times that.
  const double length = 0.24, q = 1.0;
  std::vector<double> excess;
  for (const int intervals : {3, 6, 12}) {
    const double dy = length / intervals, h = dy / std::sqrt(0.75);
    const int outside = 3, middle = 6;
    const Pillow p = pillow(13, intervals + 1 + 2 * outside, h, dy, half_slide, with_slide);
    ShapeMemory memory = memory_of(p);
    const std::vector<double> factor = lay_sheet(p.triangles, p.position, memory);
    std::vector<bool> clamped(p.position.size(), true);
    for (int j = outside + 1; j < outside + intervals; ++j)
      for (int i = 0; i < p.columns; ++i) clamped[at(p.top(i, j))] = false;
    stiffen_borders(p.position, clamped, clamped, factor, memory);
    std::vector<int> column;
    for (int j = outside; j <= outside + intervals; ++j) column.push_back(p.top(middle, j));
    const std::vector<double> stiffness = only(memory, column);
    const double small = 1e-6;
    const auto energy = [&](int a, int b) {  // rows a and b raised
      std::vector<Vec3d> x = p.position;
      for (int i = 1; i + 1 < p.columns; ++i)
        for (const int j : {a, b}) x[at(p.top(i, outside + 1 + j))] += Vec3d{0, 0, small};
      return shape_memory_energy(memory, stiffness, x) / (small * small);
    };
    const int n = intervals - 1;
    Eigen::MatrixXd H(n, n);
    for (int a = 0; a < n; ++a) H(a, a) = 0.5 * energy(a, a);  // twice as high: four times the energy
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < n; ++b)
        if (a != b) H(a, b) = energy(a, b) - 0.5 * (H(a, a) + H(b, b));
    const double area = h * dy;
    const Eigen::VectorXd u = solved_symmetric(H, Eigen::VectorXd::Constant(n, q * area));
    const double volume = u.sum() * dy,
                 exact = q * std::pow(length, 5) / (720.0 * bending_stiffness(one_sheet));
    excess.push_back(volume / exact - 1.0);
  }
  CAPTURE(excess[0], excess[1], excess[2]);
  CHECK(excess[0] == Approx(720.0 / 364.5 - 1.0).epsilon(1e-3));
  CHECK(std::log2(excess[1] / excess[2]) == Approx(2.0).margin(0.1));
}

TEST_CASE("A sheet's damping goes by area and its muscle by width, on any mesh", "[unit][sheet]") {
  double damping = 0.0, muscle = 0.0;
  for (const int resolution : {1, 2}) {
    TrunkGeometry geometry;
    geometry.resolution = resolution;
    const Trunk trunk =
        make_template_trunk(geometry, Tissue{.elasticity = ElasticLaw::sheet}, Reaction::variational);
    const std::vector<double> area = particle_areas(trunk.mesh.abdomen, trunk.model.rest);
    double of_damping = 0.0, of_area = 0.0, of_muscle = 0.0;
    for (std::size_t i = 0; i < area.size(); ++i) {
      of_area += area[i];
      if (area[i] > 0.0) of_damping += trunk.model.damping_weight[i];
    }
    for (const Fibre& fibre : trunk.model.fibres) of_muscle += fibre.activity;
    if (resolution == 1) {  // as with rings
      CHECK(of_damping == Approx(92.0).epsilon(1e-3));
      CHECK(of_muscle == Approx(12.0).epsilon(0.02));
    } else {
      CHECK(of_damping / of_area == Approx(damping).epsilon(1e-12));
      CHECK(of_muscle == Approx(muscle).epsilon(0.015));  // the sections are a 24-gon and a 12-gon
    }
    damping = of_damping / of_area;
    muscle = of_muscle;
  }
}

TEST_CASE("A sheet needs no shorter steps than rings", "[unit][sheet]") {
  for (const char* name : {"healthy", "craighero"}) {
    const Scenario ring = without_lung(name), sheet = on_sheet(ring);
    const double before = stable_time_step(make_trunk(ring).model, ring.parameters, Damping::implicit),
                 now = stable_time_step(make_trunk(sheet).model, sheet.parameters, Damping::implicit);
    CAPTURE(name, before, now);
    CHECK(now > 0.7 * before);
  }
}

TEST_CASE("A sheet finds the stiffness of held particles by itself", "[unit][sheet]") {
  Scenario given = on_sheet(without_lung("healthy"));
  const auto usual = make_trunk(given).model.shape_memory.stiffness_weight;
  given.tissue.held_stiffness = 3.0;
  CHECK(make_trunk(given).model.shape_memory.stiffness_weight == usual);
}

TEST_CASE("The published reaction has no sheet", "[unit][sheet]") {
  CHECK_THROWS_WITH(make_template_trunk({}, Tissue{.elasticity = ElasticLaw::sheet}, Reaction::published),
                    Contains("published") && Contains("sheet"));
}
