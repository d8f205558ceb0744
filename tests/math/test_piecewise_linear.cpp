#include <cmath>
#include <limits>

#include "errors/input_error.hpp"
#include "math/piecewise_linear.hpp"
#include "support/catch.hpp"

using namespace trunk;

TEST_CASE("A piecewise linear value passes through its events and is linear between", "[unit][math]") {
  const PiecewiseLinear curve({{1.0, 2.0}, {2.0, 6.0}, {4.0, 0.0}});
  CHECK(curve(1.0) == 2.0);
  CHECK(curve(2.0) == 6.0);
  CHECK(curve(4.0) == 0.0);
  CHECK(curve(1.25) == Approx(3.0));
  CHECK(curve(3.0) == Approx(3.0));
}

TEST_CASE("The value is `before` ahead of the events and the last one after them", "[unit][math]") {
  const PiecewiseLinear curve({{1.0, 2.0}, {2.0, 6.0}}, -7.0);
  CHECK(curve(std::nextafter(1.0, 0.0)) == -7.0);
  CHECK(curve(-1e9) == -7.0);
  CHECK(curve(2.0) == 6.0);
  CHECK(curve(1e9) == 6.0);
}

TEST_CASE("A single event makes a step; without events the value is `before`", "[unit][math]") {
  const PiecewiseLinear step({{1.0, 2.0}});
  CHECK(step(0.5) == 0.0);
  CHECK(step(1.0) == 2.0);
  CHECK(PiecewiseLinear()(3.0) == 0.0);
  CHECK(PiecewiseLinear({}, 1.0)(3.0) == 1.0);
  CHECK(PiecewiseLinear().empty());
}

TEST_CASE("The value is continuous between events", "[property][math]") {
  const PiecewiseLinear curve({{0.0, 0.0}, {1.0, 5.0}, {1.5, -5.0}, {9.0, 3.0}});
  const double steepest = 20.0, dt = 1e-4;
  for (double t = 0.0; t < 10.0; t += dt) {
    CAPTURE(t);
    REQUIRE(std::abs(curve(t + dt) - curve(t)) <= steepest * dt * (1 + 1e-9));
  }
}

TEST_CASE("Event times that do not increase are refused, and the error names both", "[unit][math]") {
  CHECK_THROWS_AS(PiecewiseLinear({{1.0, 0.0}, {1.0, 1.0}}), InputError);
  CHECK_THROWS_WITH(PiecewiseLinear({{2.5, 0.0}, {1.25, 1.0}}), Contains("1.25") && Contains("2.5"));
  CHECK_THROWS_AS(PiecewiseLinear({{0.0, 0.0}, {std::nan(""), 1.0}}), InputError);
}
