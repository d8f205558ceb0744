#include <catch2/catch.hpp>

#include <cmath>
#include <stdexcept>

#include "errors/input_error.hpp"
#include "search/minimise.hpp"

using namespace trunk;
using Catch::Matchers::Contains;

namespace {

/// A curved valley with its minimum 0 at (0.3, 0.09).
double valley(const Eigen::VectorXd& x) {
  return std::pow(x[0] - 0.3, 2) + 10.0 * std::pow(x[1] - x[0] * x[0], 2);
}

SearchProblem in_box(std::function<double(const Eigen::VectorXd&)> value, double low, double high) {
  return {std::move(value), Eigen::Vector2d::Constant(low), Eigen::Vector2d::Constant(high)};
}

}  // namespace

TEST_CASE("every algorithm finds the bottom of a valley and returns the best point seen", "[unit]") {
  for (const char* name : {"bobyqa", "sbplx", "cobyla", "neldermead"}) {
    INFO(name);
    double lowest = 1e300;
    SearchOptions options;
    options.algorithm = name;
    options.max_evaluations = 5000;
    const SearchResult r = minimise(in_box(
                                        [&](const Eigen::VectorXd& x) {
                                          lowest = std::min(lowest, valley(x));
                                          return valley(x);
                                        },
                                        -2, 2),
                                    Eigen::Vector2d(-1.0, 1.0), options);
    CHECK(r.converged);
    CHECK(r.best[0] == Approx(0.3).margin(1e-3));
    CHECK(r.objective == lowest);
    CHECK(valley(r.best) == r.objective);
  }
}

TEST_CASE("a minimum outside the box ends on its wall and never leaves it", "[unit]") {
  const SearchResult r = minimise(in_box(
                                      [](const Eigen::VectorXd& x) {
                                        REQUIRE(x.maxCoeff() <= 0.1);
                                        REQUIRE(x.minCoeff() >= -1.0);
                                        return valley(x);
                                      },
                                      -1, 0.1),
                                  Eigen::Vector2d(-0.5, 0.0), {});
  CHECK(r.best[0] == Approx(0.1).margin(1e-6));
}

TEST_CASE("one coordinate works with the default algorithm, which needs two", "[unit]") {
  const SearchProblem problem{[](const Eigen::VectorXd& x) { return std::pow(x[0] - 0.5, 2); },
                              Eigen::VectorXd::Constant(1, -3.0), Eigen::VectorXd::Constant(1, 3.0)};
  const SearchResult r = minimise(problem, Eigen::VectorXd::Constant(1, -2.0), {});
  CHECK(r.converged);
  CHECK(r.best[0] == Approx(0.5).margin(1e-5));
}

TEST_CASE("too few evaluations are no convergence", "[unit]") {
  SearchOptions options;
  options.max_evaluations = 8;
  const SearchResult r = minimise(in_box(valley, -2, 2), Eigen::Vector2d(-1.0, 1.0), options);
  CHECK_FALSE(r.converged);
  CHECK_THAT(r.stop_reason, Contains("8 evaluations were not enough"));
}

TEST_CASE("what the objective throws arrives with its message", "[unit]") {
  const auto throwing = [](const Eigen::VectorXd&) -> double { throw std::runtime_error("the true cause"); };
  CHECK_THROWS_WITH(minimise(in_box(throwing, -2, 2), Eigen::Vector2d(0.0, 0.0), {}), "the true cause");
}

TEST_CASE("a search can be cancelled", "[unit]") {
  int calls = 0;
  const SearchResult r =
      minimise(in_box(valley, -2, 2), Eigen::Vector2d(-1.0, 1.0), {}, [&] { return ++calls > 5; });
  CHECK_FALSE(r.converged);
  CHECK(r.stop_reason == "interrupted");
}

TEST_CASE("an unknown algorithm is refused with the names there are", "[unit]") {
  SearchOptions options;
  options.algorithm = "newton";
  CHECK_THROWS_WITH(minimise(in_box(valley, -2, 2), Eigen::Vector2d(0.0, 0.0), options),
                    Contains("newton") && Contains("bobyqa"));
}
