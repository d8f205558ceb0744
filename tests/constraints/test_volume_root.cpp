#include "constraints/volume_root.hpp"

#include <cmath>

#include "constraints/volume_and_contact.hpp"
#include "support/catch.hpp"
#include "support/trunks.hpp"

using namespace trunk;
using namespace trunk::test;

namespace {

/// (lambda - a)(lambda - b)(lambda - c) times k, plus the target.
VolumeCubic<double> cubic_with_roots(double a, double b, double c, double k, double target) {
  return {target - k * a * b * c, k * (a * b + b * c + c * a), -k * (a + b + c), k};
}

}  // namespace

TEST_CASE("The cubic is the volume along the direction", "[property][constraints]") {
  Random random(41);
  double worst = 0.0;
  for (const Mesh& mesh : closed_meshes()) {
    INFO(mesh.name);
    Model model = free_body(mesh, Reaction::variational, 0.2);
    hold_volume(mesh, model);
    for (Vec3d& m : model.mobility) m = Vec3d{1.0, random.unit() < 0.3 ? 0.0 : 1.0, 1.0};  // some axes held
    Workspace<double> w = make_workspace(model, Parameters<double>{1000.0, 0.0, 20.0}, 1e-3);
    w.next = deformed(mesh.position, 0.02, random);
    calc_ring_areas<double>(model.abdomen.rings, w.next, w.reactions.area);
    detail::calc_direction(model, rest_state<double>(model), w);
    const VolumeCubic<double> cubic = detail::volume_along_direction(w);
    const double unit =
        0.1 / largest(w.direction);  // the lambda that moves a particle by 0.1 m, so that all terms count
    for (const double share : {-2.0, -0.5, 0.0, 0.01, 0.3, 1.0, 3.0}) {
      std::vector<Vec3d> moved = w.next;
      for (std::size_t i = 0; i < moved.size(); ++i) moved[i] += (share * unit) * w.direction[i];
      const double volume = enclosed_volume<double>(mesh.triangles, moved);
      const double error = std::abs(cubic(share * unit) - volume) / std::max(std::abs(volume), 1e-3);
      worst = std::max(worst, error);
      REQUIRE(error < 1e-12);
    }
    const double h = 1e-4 * unit;
    CHECK(cubic.slope(unit) == Approx((cubic(unit + h) - cubic(unit - h)) / (2 * h)).epsilon(1e-6));
  }
  WARN("largest relative deviation of the cubic from the volume: " << worst);
}

TEST_CASE("GSL's root is a root, and the nearest one", "[unit][constraints]") {
  const auto three = cubic_with_roots(-0.7, 2.0, 5.0, 3.0, 1.5);
  REQUIRE(nearest_real_root(three, 1.5));
  CHECK(*nearest_real_root(three, 1.5) == Approx(-0.7));
  CHECK(*nearest_real_root({1.0, 2.0, 0.0, 0.0}, 2.0) == Approx(0.5));    // a straight line
  CHECK(*nearest_real_root({0.0, 3.0, 1.0, 0.0}, -2.0) == Approx(-1.0));  // a parabola, roots -1 and -2
}

TEST_CASE("The root of the kernel is GSL's if a step changes the volume little", "[property][constraints]") {
  // Changes up to a twentieth of the volume; a time step changes it by less than a thousandth.
  Random random(42);
  double worst = 0.0;
  for (const Mesh& mesh : closed_meshes()) {
    INFO(mesh.name);
    Model model = free_body(mesh, Reaction::variational, 0.2);
    hold_volume(mesh, model);
    Workspace<double> w = make_workspace(model, Parameters<double>{1000.0, 0.0, 20.0}, 1e-3);
    for (int i = 0; i < 50; ++i) {
      w.next = deformed(mesh.position, 0.003, random);
      calc_ring_areas<double>(model.abdomen.rings, w.next, w.reactions.area);
      detail::calc_direction(model, rest_state<double>(model), w);
      const VolumeCubic<double> cubic = detail::volume_along_direction(w);
      const double target = cubic.c0 * random.between(0.95, 1.05);
      const double root = solve_volume(cubic, target);
      const auto oracle = nearest_real_root(cubic, target);
      REQUIRE(oracle);
      CHECK(root == Approx(*oracle).epsilon(1e-9).margin(1e-9 * std::abs(target / cubic.c1)));
      worst = std::max(worst, std::abs(cubic(root) / target - 1.0));
    }
  }
  CAPTURE(worst);
  CHECK(worst < 1e-13);
}

TEST_CASE("The kernel takes the nearest of three roots", "[unit][constraints]") {
  Random random(43);
  for (int i = 0; i < 200; ++i) {
    // The nearest root well apart from the others, as a small volume change leaves it.
    const double near = random.between(-0.1, 0.1);
    const auto cubic = cubic_with_roots(near, random.between(1, 2), random.between(-3, -1), 1.0, 0.4);
    CAPTURE(near);
    REQUIRE(solve_volume(cubic, 0.4) == Approx(near).epsilon(1e-9).margin(1e-12));
  }
}

TEST_CASE("The closed form gives the root if Newton's method fails", "[unit][constraints]") {
  // Slope 0 at 0: Newton divides by zero at once.
  CHECK(solve_volume(VolumeCubic<double>{0.0, 0.0, 0.0, 1.0}, 8.0) == Approx(2.0));
  CHECK(std::abs(solve_volume(VolumeCubic<double>{-1.0, 0.0, 1.0, 0.0}, 0.0)) == Approx(1.0));
}

TEST_CASE("The root is NaN if there is no real root", "[unit][constraints]") {
  CHECK(std::isnan(solve_volume(VolumeCubic<double>{1.0, 0.0, 1.0, 0.0}, 0.5)));  // 1 + x^2 never is 0.5
  CHECK(std::isnan(solve_volume(VolumeCubic<double>{1.0, 0.0, 0.0, 0.0}, 2.0)));  // nothing moves
  const double nan = std::nan("");
  CHECK(std::isnan(solve_volume(VolumeCubic<double>{nan, 1.0, 0.0, 0.0}, 2.0)));
  CHECK(std::isnan(solve_volume(VolumeCubic<double>{1.0, nan, 0.0, 0.0}, 2.0)));
  CHECK(std::isnan(solve_volume(VolumeCubic<double>{1.0, 1.0, 0.0, 1.0}, nan)));
  CHECK_FALSE(nearest_real_root({1.0, 0.0, 1.0, 0.0}, 0.5));
}
