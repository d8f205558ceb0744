#include <algorithm>
#include <numbers>

#include "errors/input_error.hpp"
#include "mesh/volume.hpp"
#include "support/catch.hpp"
#include "support/zoo.hpp"
#include "surface/align.hpp"
#include "surface/axes.hpp"
#include "surface/repair.hpp"
#include "surface/thinned.hpp"

using namespace trunk;
using namespace trunk::test;

namespace {

MeasuredSurface measured(const Mesh& mesh) {
  return {mesh.name, mesh.position, mesh.triangles};
}

/// Returns the surface as in STL: every triangle has points of its own.
MeasuredSurface soup_of(const Mesh& mesh) {
  MeasuredSurface s;
  for (const Triangle& t : mesh.triangles) {
    const int first = static_cast<int>(s.points.size());
    for (const int i : t) s.points.push_back(mesh.position[static_cast<std::size_t>(i)]);
    s.triangles.push_back({first, first + 1, first + 2});
  }
  return s;
}

/// A dome like a diaphragm: wider than deep, its border higher in front; RAS, m.
MeasuredSurface dome(int rings, double shrink = 0.0) {
  MeasuredSurface s;
  const int around = 4 * rings;
  const auto at = [&](double r, double angle) {
    const double x = r * std::cos(angle), y = r * std::sin(angle);
    return Vec3d{(0.15 - shrink) * x, (0.1 - shrink) * y,
                 (0.15 - shrink) * std::sqrt(1.0 - 0.97 * r * r) + 0.02 * y};
  };
  s.points.push_back(at(0.0, 0.0));
  for (int ring = 1; ring <= rings; ++ring)
    for (int k = 0; k < around; ++k)
      s.points.push_back(at(static_cast<double>(ring) / rings, 2.0 * std::numbers::pi * k / around));
  for (int ring = 1; ring <= rings; ++ring)
    for (int k = 0; k < around; ++k) {
      const int next = (k + 1) % around, outer = 1 + (ring - 1) * around, inner = outer - around;
      if (ring == 1) {
        s.triangles.push_back({0, outer + k, outer + next});
      } else {
        s.triangles.push_back({inner + k, outer + k, outer + next});
        s.triangles.push_back({inner + k, outer + next, inner + next});
      }
    }
  return s;
}

MeasuredSurface joined(MeasuredSurface a, const MeasuredSurface& b) {
  const int first = static_cast<int>(a.points.size());
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  for (const Triangle& t : b.triangles) a.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  return a;
}

double volume_of(const MeasuredSurface& s) {
  return enclosed_volume<double>(s.triangles, s.points);
}

double upward_area(const MeasuredSurface& s) {
  Vec3d net;
  for (const Triangle& t : s.triangles) {
    const auto at = [&](std::size_t i) { return s.points[static_cast<std::size_t>(t[i])]; };
    net += 0.5 * cross(at(1) - at(0), at(2) - at(0));
  }
  return net.z();
}

}  // namespace

TEST_CASE("Triangles with points of their own become a closed surface again", "[unit][surface]") {
  for (const Mesh& mesh : closed_meshes()) {
    INFO(mesh.name);
    MeasuredSurface s = soup_of(mesh);
    Random random(7);
    for (Vec3d& p : s.points) p += random.vector(1e-7) + Vec3d(-700, 0, 3);  // numbers were rounded
    const RepairReport report = repair(s);
    CHECK(s.points.size() == mesh.position.size());
    CHECK(report.merged_points == 3 * mesh.triangles.size() - mesh.position.size());
    CHECK(report.isolated_points == 0);
    CHECK(report.closed());
    CHECK(s.triangles.size() == mesh.triangles.size());
    CHECK_NOTHROW(Surface("s", s.triangles, static_cast<int>(s.points.size())));
  }
}

TEST_CASE("Useless points and triangles are dropped and counted", "[unit][surface]") {
  MeasuredSurface s = measured(icosphere(0.1, 2));
  const std::size_t triangles = s.triangles.size(), points = s.points.size();
  s.points.push_back({9, 9, 9});
  s.points.push_back(s.points[0]);
  s.triangles.push_back(s.triangles[5]);
  s.triangles.push_back({s.triangles[6][1], s.triangles[6][0], s.triangles[6][2]});
  s.triangles.push_back({0, 1, static_cast<int>(points) + 1});
  const RepairReport report = repair(s);
  CHECK(report.isolated_points == 1);
  CHECK(report.merged_points == 1);
  CHECK(report.duplicates == 2);
  CHECK(report.degenerate == 1);
  CHECK(report.triangles_read == triangles + 3);
  CHECK(s.triangles.size() == triangles);
  CHECK(s.points.size() == points);
  CHECK(report.closed());
}

TEST_CASE("Neighbours are turned to agree, and a closed surface faces outward", "[unit][surface]") {
  Random random(8);
  for (const Mesh& mesh : {icosphere(0.1, 2), torus(), star(), two_tetrahedra()}) {
    INFO(mesh.name);
    MeasuredSurface s = measured(mesh);
    const double volume = volume_of(s);
    std::size_t turned = 0;
    for (Triangle& t : s.triangles)
      if (random.unit() < 0.2) {
        std::swap(t[0], t[1]);
        ++turned;
      }
    const RepairReport report = repair(s);
    CHECK(report.turned == turned);
    CHECK(report.oriented);
    CHECK(volume_of(s) == Approx(volume));
    for (Triangle& t : s.triangles) std::swap(t[0], t[1]);
    repair(s);
    CHECK(volume_of(s) == Approx(volume));
  }
}

TEST_CASE("A one-sided surface is reported as such", "[unit][surface]") {
  MeasuredSurface strip;  // a Moebius strip
  constexpr int rungs = 20;
  for (int i = 0; i < rungs; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / rungs;
    for (const double w : {-0.02, 0.02})
      strip.points.push_back({(0.1 + w * std::cos(0.5 * angle)) * std::cos(angle),
                              (0.1 + w * std::cos(0.5 * angle)) * std::sin(angle),
                              w * std::sin(0.5 * angle)});
  }
  for (int i = 0; i < rungs; ++i) {
    const int a = 2 * i, b = a + 1, c = i + 1 < rungs ? a + 2 : 1, d = i + 1 < rungs ? a + 3 : 0;
    strip.triangles.push_back({a, b, c});
    strip.triangles.push_back({b, d, c});
  }
  const RepairReport report = repair(strip);
  CHECK_FALSE(report.oriented);
  CHECK(report.borders == 1);
}

TEST_CASE("Holes, pieces and specks are counted", "[unit][surface]") {
  MeasuredSurface s = measured(icosphere(0.1, 3));
  s.triangles.erase(s.triangles.begin() + 100);
  s.triangles.erase(s.triangles.begin() + 700);
  RepairReport report = repair(s);
  CHECK(report.borders == 2);
  CHECK_FALSE(report.closed());
  MeasuredSurface far = measured(icosphere(0.08, 2));
  for (Vec3d& p : far.points) p += Vec3d(0.3, 0, 0);
  MeasuredSurface speck = measured(tetrahedron(0.003));
  for (Vec3d& p : speck.points) p += Vec3d(0.0, 0.3, 0);
  s = joined(joined(s, far), speck);
  report = repair(s);
  CHECK(report.specks == 1);
  CHECK(report.pieces == 2);
}

TEST_CASE("A dome faces up, however it faced before", "[unit][surface]") {
  MeasuredSurface s = dome(8);
  const double area = upward_area(s);
  REQUIRE(area > 0.0);
  for (Triangle& t : s.triangles) std::swap(t[0], t[1]);
  const RepairReport report = repair(s);
  CHECK(upward_area(s) == Approx(area));
  CHECK(report.borders == 1);
  CHECK_FALSE(report.two_sided());
}

TEST_CASE("A sheet with two sides is replaced by its middle", "[unit][surface]") {
  const double thickness = 0.002;
  const MeasuredSurface outer = dome(20), inner = dome(20, thickness);
  MeasuredSurface turned = inner;
  for (Triangle& t : turned.triangles) std::swap(t[0], t[1]);
  MeasuredSurface closed = joined(outer, turned);
  const int around = 80, rim = 1 + 19 * around, other = static_cast<int>(outer.points.size());
  for (int k = 0; k < around; ++k) {
    const int a = rim + k, b = rim + (k + 1) % around;
    closed.triangles.push_back({a, a + other, b});
    closed.triangles.push_back({b, a + other, b + other});
  }
  MeasuredSurface middle = dome(20, 0.5 * thickness);
  for (MeasuredSurface sheet : {joined(outer, inner), joined(outer, turned), closed}) {
    const RepairReport report = repair(sheet);
    CHECK(report.two_sided());
    CHECK(report.sheet_thickness == Approx(thickness).epsilon(0.2));
    CHECK(report.sheet_share > 0.9);
    CHECK(sheet.triangles.size() >= outer.triangles.size());
    CHECK(sheet.triangles.size() <= outer.triangles.size() + 2 * around);
    CHECK(upward_area(sheet) > 0.0);
    const ClosestPoints to(middle.points, middle.triangles);
    std::vector<double> off;
    for (const Vec3d& p : sheet.points) off.push_back(to(p).distance);
    CHECK(*std::max_element(off.begin(), off.end()) < 0.6 * thickness);  // the rim's lower edge stays
    std::nth_element(off.begin(), off.begin() + static_cast<std::ptrdiff_t>(off.size() / 2), off.end());
    CHECK(off[off.size() / 2] < 0.1 * thickness);
  }
  MeasuredSurface twice = joined(outer, outer);
  const RepairReport report = repair(twice);
  CHECK(report.duplicates == outer.triangles.size());
  CHECK_FALSE(report.two_sided());
  MeasuredSurface ball = measured(icosphere(0.1, 3));
  CHECK(repair(ball).sheet_share == 0.0);
}

TEST_CASE("Axes follow from letters or from coordinates", "[unit][surface]") {
  const Vec3d p{1, 2, 3};
  const auto same = [](const Vec3d& a, const Vec3d& b) { return norm(a - b) == 0.0; };
  CHECK(same(Axes("RAS")(p), {1, 2, 3}));
  CHECK(same(Axes("LPS")(p), {-1, -2, 3}));
  CHECK(same(Axes("lsa")(p), {-1, 3, 2}));  // x to the left, y up, z forward
  CHECK(same(Axes("IRA")(p), {2, 3, -1}));
  CHECK(same(Axes("x,-z,y")(p), {1, -3, 2}));
  CHECK(same(Axes("-x, z, +y")(p), {-1, 3, 2}));
  CHECK(Axes("-x,z,y").letters() == "LSA");
  CHECK(Axes("y,z,-x").letters() == "IRA");
  CHECK_FALSE(Axes("LPS").mirrors());
  CHECK_FALSE(Axes("LSA").mirrors());
  CHECK(Axes("RSA").mirrors());
  CHECK(Axes("LAS").mirrors());
  for (const char* bad : {"", "RA", "RAR", "RLS", "RAX", "xyz", "x,y", "x,y,x", "x,y,z,", "x,y,z,x", "x,,y",
                          "-", "x,-", "R,A,S", "a,b,c"})
    CHECK_THROWS_AS(Axes(bad), InputError);
}

TEST_CASE("The axes of a dome are found, whichever they are", "[unit][surface]") {
  const MeasuredSurface upright = dome(10);
  for (const char* letters : {"RAS", "LPS", "LSA", "PIR", "ASR", "SRA", "SAL"}) {
    REQUIRE_FALSE(Axes(letters).mirrors());
    MeasuredSurface turned = upright;
    const std::string text = letters;
    for (Vec3d& p : turned.points) {
      const double ras[3] = {p.x(), p.y(), p.z()};
      double of_file[3];
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t same = std::string("RAS").find(text[i]),
                          opposite = std::string("LPI").find(text[i]);
        of_file[i] = same < 3 ? ras[same] : -ras[opposite];
      }
      p = {of_file[0], of_file[1], of_file[2]};
    }
    repair(turned);
    const auto guess = guess_axes(turned);
    REQUIRE(guess);
    CHECK(guess->axes.letters() == letters);
    CHECK(guess->front_known);
  }
  MeasuredSurface ball = measured(icosphere(0.1, 2));
  CHECK_FALSE(guess_axes(ball));
  MeasuredSurface level = upright;  // a border of one height does not show the front
  for (Vec3d& p : level.points) p += Vec3d(0.0, 0.0, -0.2 * p.y());
  const auto guess = guess_axes(level);
  REQUIRE(guess);
  CHECK_FALSE(guess->front_known);
  CHECK_THAT(guess->reasons, Contains("front and back cannot be told"));
}

TEST_CASE("Half a dome is known by its cut, and shows no axes", "[unit][surface][faults]") {
  const MeasuredSurface whole = dome(12);
  CHECK_FALSE(cut_of_half_dome(whole));
  for (const double side : {1.0, -1.0}) {
    MeasuredSurface half = whole;
    std::erase_if(half.triangles, [&](const Triangle& t) {
      double x = 0.0;
      for (const int i : t) x += half.points[static_cast<std::size_t>(i)].x();
      return side * x < 0.0;
    });
    repair(half);
    const auto cut = cut_of_half_dome(half);
    REQUIRE(cut);
    CHECK(cut->measured_side == side);
    CHECK(std::abs(cut->x) < 0.02);
    CHECK_FALSE(guess_axes(half));
  }
}

TEST_CASE("A small piece far away is left out, and a near one stays", "[unit][surface][faults]") {
  for (const auto& [distance, islands] : {std::pair{0.4, 1u}, {0.13, 0u}}) {
    MeasuredSurface near = measured(icosphere(0.015, 2));
    for (Vec3d& p : near.points) p += Vec3d(distance, 0, 0);
    MeasuredSurface s = joined(measured(icosphere(0.1, 3)), near);
    const RepairReport report = repair(s);
    CHECK(report.islands == islands);
    CHECK(report.pieces == 2 - islands);
    if (islands > 0) CHECK(report.island_distance == Approx(distance - 0.115).epsilon(0.05));
  }
}

TEST_CASE("A shell of 8 mm is replaced by its middle", "[unit][surface][faults]") {
  MeasuredSurface shell = joined(dome(20), dome(20, 0.008));
  const RepairReport report = repair(shell);
  CHECK(report.two_sided());
  CHECK(report.sheet_thickness == Approx(0.008).epsilon(0.2));
  const MeasuredSurface middle = dome(20, 0.004);
  const ClosestPoints to(middle.points, middle.triangles);
  std::vector<double> off;
  for (const Vec3d& p : shell.points) off.push_back(to(p).distance);
  std::nth_element(off.begin(), off.begin() + static_cast<std::ptrdiff_t>(off.size() / 2), off.end());
  CHECK(off[off.size() / 2] < 0.001);
}

TEST_CASE("A moved surface is brought back", "[unit][surface]") {
  const MeasuredSurface still = dome(12);
  MeasuredSurface moved = still;
  const double angle = 0.2;
  for (Vec3d& p : moved.points)
    p = {std::cos(angle) * p.x() - std::sin(angle) * p.y() + 0.4,
         std::sin(angle) * p.x() + std::cos(angle) * p.y(), p.z() - 0.1};
  const RigidMove move = aligned(moved.points, moved.triangles, ClosestPoints(still.points, still.triangles),
                                 middle_of_area(still.points, still.triangles));
  CHECK(move.angle == Approx(angle).epsilon(0.02));
  double worst = 0.0;
  for (std::size_t i = 0; i < moved.points.size(); ++i)
    worst = std::max(worst, norm(move(moved.points[i]) - still.points[i]));
  CHECK(worst < 0.005);  // iterated closest points creep along the surface
}

TEST_CASE("A surface thinned for display keeps its shape", "[unit][surface]") {
  const MeasuredSurface whole = measured(icosphere(0.1, 4));
  CHECK(thinned(whole, whole.triangles.size()).triangles == whole.triangles);
  const MeasuredSurface few = thinned(whole, 800);
  CHECK(few.triangles.size() <= 800);
  CHECK(few.triangles.size() > 300);
  for (const Vec3d& p : few.points) CHECK(norm(p) == Approx(0.1).epsilon(0.05));
  CHECK(volume_of(few) == Approx(volume_of(whole)).epsilon(0.1));
}

TEST_CASE("A flat surface is known by its flatness", "[unit][surface]") {
  MeasuredSurface flat = dome(5);
  for (Vec3d& p : flat.points) p = {p.x(), p.y(), 0.3 * p.x()};
  CHECK(flatness(flat) < 1e-6);
  CHECK(flatness(dome(5)) > 0.1);
}
