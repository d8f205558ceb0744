#include <cmath>

#include "activation/breath_activation.hpp"
#include "support/catch.hpp"

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

TEST_CASE("Knots multiply the heights of the lines, which stay straight between knots",
          "[unit][activation]") {
  BreathActivation<double> straight{0.2, 1.2, 0.4, 1.6, 0.35}, bent = straight;
  const double knot_s[] = {0.4, 0.6, 0.8, 1.0, 1.2, 1.6, 2.2, 2.6, 3.0};
  for (std::size_t k = 0; k < ShapeKnots::count; ++k) {
    bent = straight;
    bent.shape[k] = 1.7;
    CAPTURE(k);
    CHECK(bent(knot_s[k]) == Approx(1.7 * straight(knot_s[k])));
    for (std::size_t other = 0; other < ShapeKnots::count; ++other)
      if (other != k) CHECK(bent(knot_s[other]) == Approx(straight(knot_s[other])));
    for (const double end_s : {0.2, 1.4, 1.8, 3.4})
      CHECK(bent(end_s) == Approx(straight(end_s)).margin(just));
    const double before = knot_s[k] - 1e-4, after = knot_s[k] + 1e-4;
    CHECK(bent(before) == Approx(bent(after)).margin(1e-3));  // continuous
  }
  bent.shape.fill(0.0);
  for (double t = -1.0; t < 6.0; t += 1e-3) {
    REQUIRE(bent(t) >= 0.0);
    REQUIRE(straight(t) >= 0.0);
  }
  CHECK(bent(0.8) == 0.0);
}

TEST_CASE("An activation that repeats lasts from one onset to the next", "[property][activation]") {
  const BreathActivation<double> once{.onset_s = -0.3, .rise_s = 1.0, .fast_fall_s = 0.5, .slow_fall_s = 2.0};
  const double breath_s = 3.0;  // shorter than the activation: its tail is cut
  for (double t = -0.3; t < 2.7; t += 0.01) {
    REQUIRE(once.repeated(t, breath_s) == Approx(once(t)).margin(1e-12));
    for (const double breaths : {-7.0, -1.0, 1.0, 4.0})
      REQUIRE(once.repeated(t + breaths * breath_s, breath_s) == Approx(once(t)).margin(1e-9));
  }
  CHECK(once.repeated(2.7 - just, breath_s) == Approx(once(2.7 - just)));  // of this breath
  CHECK(once.repeated(2.7 + just, breath_s) == Approx(0.0).margin(1e-9));  // of the next one
  CHECK(once.repeated(2.9, breath_s) == Approx(0.2));
  BreathActivation<double> own = once;
  own.period_s = 2.0;  // comes before that of the breath
  CHECK(own.repeated(0.1 + 2.0, breath_s) == Approx(once(0.1)));
}
