#include <catch2/catch.hpp>
#include <cmath>

#include "activation/breath_activation.hpp"

using namespace trunk;

namespace {

constexpr double just = 1e-12;

}  // namespace

TEST_CASE("The activation of the paper rises for 2 s, falls fast for 0.5 s and slowly for 2 s",
          "[unit][activation]") {
  const BreathActivation<double> a;
  CHECK(a(0.0) == 0.0);
  CHECK(a(1.0) == Approx(0.5));
  CHECK(a(2.0) == Approx(1.0));
  CHECK(a(2.25) == Approx(0.7));
  CHECK(a(2.5) == Approx(0.4));
  CHECK(a(3.5) == Approx(0.2));
  CHECK(a(4.5) == Approx(0.0).margin(1e-15));
}

TEST_CASE("Outside the breath the activation is 0", "[unit][activation]") {
  const BreathActivation<double> a{.onset_s = 0.3};
  for (const double t : {-5.0, 0.0, 0.3, 4.8, 4.9, 100.0}) {
    CAPTURE(t);
    CHECK(a(t) == Approx(0.0).margin(1e-15));
  }
  CHECK(a(0.3 + 1.0) == Approx(0.5));
}

TEST_CASE("The activation is continuous and stays within 0 and 1", "[property][activation]") {
  const BreathActivation<double> a{0.2, 1.3, 0.4, 1.7, 0.35, 0.0};
  const double steepest = 0.65 / 0.4, dt = 1e-4;
  for (double t = -1.0; t < 6.0; t += dt) {
    REQUIRE(a(t) >= 0.0);
    REQUIRE(a(t) <= 1.0);
    REQUIRE(std::abs(a(t + dt) - a(t)) <= steepest * dt * (1.0 + 1e-9));
  }
  for (const double corner : {0.2, 1.5, 1.9, 3.6}) {
    CAPTURE(corner);
    CHECK(a(corner - just) == Approx(a(corner + just)).margin(1e-10));
  }
}

TEST_CASE("A fast fall to 0 or to 1 has no gap", "[unit][activation]") {
  const BreathActivation<double> to_zero{.fast_fall_level = 0.0}, stays{.fast_fall_level = 1.0};
  CHECK(to_zero(2.5) == Approx(0.0).margin(1e-15));
  CHECK(to_zero(3.5) == 0.0);
  CHECK(stays(2.3) == Approx(1.0));
  CHECK(stays(3.5) == Approx(0.5));
}

TEST_CASE("The activation repeats with its period", "[property][activation]") {
  const BreathActivation<double> once{}, a{.period_s = 5.0};
  for (double t = 0.01; t < 5.0; t += 0.0371) {
    CAPTURE(t);
    CHECK(a(t) == Approx(once(t)).margin(1e-12));
    CHECK(a(t + 15.0) == Approx(a(t)).margin(1e-9));
    CHECK(a(t - 5.0) == Approx(a(t)).margin(1e-9));
  }
}

TEST_CASE("The activation is the same in another scalar", "[unit][activation]") {
  const BreathActivation<double> a{};
  const BreathActivation<long double> b{};
  for (double t = 0.0; t < 5.0; t += 0.013) CHECK(a(t) == Approx(static_cast<double>(b(t))).margin(1e-15));
}
