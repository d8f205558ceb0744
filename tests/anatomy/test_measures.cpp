#include "support/catch.hpp"
#include "support/trunks.hpp"

using namespace trunk;
using namespace trunk::test;

namespace {

const Trunk& healthy() {
  static const Trunk trunk = make_template_trunk(TrunkGeometry{}, Tissue{}, Reaction::variational);
  return trunk;
}

std::vector<Vec3d> shifted(std::vector<Vec3d> x, const char* name, const Vec3d& shift) {
  for (int i : healthy().mesh.named(name)) x[static_cast<std::size_t>(i)] += shift;
  return x;
}

Measures measured(const std::vector<Vec3d>& after) {
  return measures_between(shape_of(healthy(), healthy().model.rest), shape_of(healthy(), after));
}

}  // namespace

TEST_CASE("Every measure is 0 if nothing moved", "[unit][anatomy]") {
  const Measures m = measured(healthy().model.rest);
  for (const double value :
       {m.delta_v, m.delta_l, m.delta_l_fraction, m.delta_h, m.delta_r, m.excursion_right, m.excursion_left})
    CHECK(value == 0.0);
  CHECK(m.end_expiratory_volume == Approx(4760e-6));
  CHECK(m.end_inspiratory_volume == Approx(4760e-6));
}

TEST_CASE("A lower top of the zone shortens the zone and leaves the dome higher above it",
          "[unit][anatomy]") {
  const Measures m = measured(shifted(healthy().model.rest, "apposition_top", {0, 0, -0.009}));
  CHECK(m.delta_l == Approx(0.009));
  CHECK(m.delta_l_fraction == Approx(0.009 / 0.149));
  CHECK(m.delta_h == Approx(-0.009));
  CHECK(m.delta_r == Approx(0.0).margin(1e-15));
  CHECK(m.excursion_right == Approx(0.0).margin(1e-15));
}

TEST_CASE("A descent like a piston shortens the zone, flattens nothing and adds its cross-section's volume",
          "[unit][anatomy]") {
  std::vector<Vec3d> x = healthy().model.rest;
  for (const char* name : {"apposition_top", "central_tendon"}) x = shifted(x, name, {0, 0, -0.009});
  const Measures m = measured(x);
  CHECK(m.delta_l == Approx(0.009));
  CHECK(m.delta_h == Approx(0.0).margin(1e-15));
  CHECK(m.excursion_right == Approx(0.009));
  CHECK(m.excursion_left == Approx(0.009));
  // The wall of the lung from the ring to its base is stretched, so it is a frustum of full section: 12-gon
  // area.
  const double twelve_gon = 0.5 * 12 * std::sin(std::numbers::pi / 6) * 0.160 * 0.105;
  CHECK(m.delta_v == Approx(0.009 * twelve_gon));
  CHECK(m.end_inspiratory_volume - m.end_expiratory_volume == Approx(m.delta_v));
}

TEST_CASE("Lower domes are flatter and have descended, each on its own side", "[unit][anatomy]") {
  const Measures m = measured(shifted(healthy().model.rest, "dome_top_right", {0, 0, -0.006}));
  CHECK(m.excursion_right == Approx(0.006));
  CHECK(m.excursion_left == Approx(0.0).margin(1e-15));
  CHECK(m.delta_h == Approx(0.003));
  CHECK(m.delta_l == 0.0);
  CHECK(m.delta_v > 0.0);
}

TEST_CASE("A wider zone widens by the mean of its rings", "[unit][anatomy]") {
  std::vector<Vec3d> x = healthy().model.rest;
  for (int i : healthy().mesh.named("apposition_middle")) {
    Vec3d& p = x[static_cast<std::size_t>(i)];
    p = {1.05 * p.x(), p.y(), p.z()};
  }
  CHECK(measured(x).delta_r == Approx(0.5 * 0.05 * 0.160));
}
