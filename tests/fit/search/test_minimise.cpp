#include <cmath>
#include <stdexcept>

#include "errors/input_error.hpp"
#include "search/minimise.hpp"
#include "search/multistart.hpp"
#include "support/catch.hpp"

using namespace trunk;

namespace {

using Residuals = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

LeastSquares in_box(const Residuals& residuals, double low, double high, Eigen::Index size = 2) {
  const auto outcomes = [residuals](const std::vector<Eigen::VectorXd>& some) {
    std::vector<Outcome> all;
    for (const Eigen::VectorXd& x : some) {
      const Eigen::VectorXd r = residuals(x);
      all.push_back({r, r.squaredNorm()});
    }
    return all;
  };
  return {outcomes, Eigen::VectorXd::Constant(size, low), Eigen::VectorXd::Constant(size, high)};
}

/// A curved valley with its minimum 0 at (0.3, 0.09).
Eigen::VectorXd valley(const Eigen::VectorXd& x) {
  return Eigen::Vector2d(x[0] - 0.3, std::sqrt(10.0) * (x[1] - x[0] * x[0]));
}

SearchOptions with(const char* algorithm, int evaluations = 5000) {
  SearchOptions options;
  options.algorithm = algorithm;
  options.max_evaluations = evaluations;
  return options;
}

}  // namespace

TEST_CASE("Every algorithm finds the bottom of a valley and returns the best point seen", "[unit]") {
  for (const char* name : {"bobyqa", "sbplx", "cobyla", "neldermead", "lbfgs", "slsqp", "mma", "lm"}) {
    INFO(name);
    double lowest = 1e300;
    const LeastSquares problem = in_box(
        [&](const Eigen::VectorXd& x) {
          lowest = std::min(lowest, valley(x).squaredNorm());
          return valley(x);
        },
        -2, 2);
    const SearchResult r = minimise(problem, Eigen::Vector2d(-1.0, 1.0), with(name));
    CHECK(r.converged);
    CHECK(r.best[0] == Approx(0.3).margin(1e-3));
    CHECK(r.best[1] == Approx(0.09).margin(1e-3));
    CHECK(valley(r.best).squaredNorm() == r.objective);
    CHECK(r.objective <= lowest + 1e-9);  // differences for a gradient may see a point lower by round-off
  }
}

TEST_CASE("Global algorithms leave a local minimum that a local one stays in", "[unit]") {
  // Two hollows: 0 at (1, 1), 0.09 at (-1, -1).
  const LeastSquares problem = in_box(
      [](const Eigen::VectorXd& x) {
        const double well = x[0] * x[0] - 1.0;
        return Eigen::Vector3d(2.0 * well, x[1] - x[0], 0.15 * (x[0] - 1.0));
      },
      -2, 2);
  const Eigen::Vector2d wrong(-1.2, -0.8);
  for (const char* name : {"bobyqa", "lm"}) CHECK(minimise(problem, wrong, with(name)).best[0] < 0.0);
  for (const char* name : {"mlsl", "direct"}) {
    INFO(name);
    const SearchResult r = minimise(problem, wrong, with(name, 400));
    CHECK(r.converged);
    CHECK(r.best[0] == Approx(1.0).margin(1e-3));
  }
  double lowest = 1e300;
  for (const Eigen::VectorXd& start : sobol_starts(problem, 8, 1))
    lowest = std::min(lowest, minimise(problem, start, with("lm")).objective);
  CHECK(lowest < 1e-6);
}

TEST_CASE("Sobol starts fill the box, the same for the same seed", "[unit]") {
  const LeastSquares problem = in_box(valley, -2, 3);
  const auto starts = sobol_starts(problem, 64, 7), again = sobol_starts(problem, 64, 7);
  int quarter[2][2] = {};
  for (std::size_t i = 0; i < starts.size(); ++i) {
    CHECK(starts[i] == again[i]);
    REQUIRE((problem.inside(starts[i]) - starts[i]).norm() == 0.0);
    ++quarter[starts[i][0] > 0.5][starts[i][1] > 0.5];
  }
  for (const auto& row : quarter)
    for (const int count : row) CHECK(count >= 12);  // 16 each, were it not shifted
  CHECK(starts[0] != sobol_starts(problem, 1, 8)[0]);
}

TEST_CASE("A minimum outside the box ends on its wall and never leaves it", "[unit]") {
  for (const char* name : {"bobyqa", "lm"}) {
    const LeastSquares problem = in_box(
        [](const Eigen::VectorXd& x) {
          REQUIRE(x.maxCoeff() <= 0.1 + 1e-12);
          REQUIRE(x.minCoeff() >= -1.0 - 1e-12);
          return valley(x);
        },
        -1, 0.1);
    CHECK(minimise(problem, Eigen::Vector2d(-0.5, 0.0), with(name)).best[0] == Approx(0.1).margin(1e-4));
  }
}

TEST_CASE("One coordinate works with the default algorithm, which needs two", "[unit]") {
  const LeastSquares problem =
      in_box([](const Eigen::VectorXd& x) { return Eigen::VectorXd::Constant(1, x[0] - 0.5); }, -3, 3, 1);
  for (const char* name : {"bobyqa", "lm"}) {
    const SearchResult r = minimise(problem, Eigen::VectorXd::Constant(1, -2.0), with(name));
    CHECK(r.converged);
    CHECK(r.best[0] == Approx(0.5).margin(1e-5));
  }
}

TEST_CASE("A search takes its step back if the model fails", "[unit]") {
  LeastSquares problem = in_box(valley, -2, 2);
  const auto outcomes = problem.outcomes;
  int failures = 0;
  problem.outcomes = [&](const std::vector<Eigen::VectorXd>& some) {
    std::vector<Outcome> all = outcomes(some);
    for (std::size_t i = 0; i < some.size(); ++i)
      if (some[i][0] > 0.31) {
        all[i] = {std::nullopt, 1e6};
        ++failures;
      }
    return all;
  };
  const SearchResult r = minimise(problem, Eigen::Vector2d(-1.5, -1.5), with("lm"));
  CHECK(failures > 0);
  CHECK(r.best[0] == Approx(0.3).margin(1e-3));
}

TEST_CASE("Coordinates that are held do not move", "[unit]") {
  const LeastSquares problem = in_box(valley, -2, 2);
  const Eigen::Vector2d at(0.7, -1.0);
  const SearchResult r =
      minimise(with_fixed(problem, at, {1}), Eigen::VectorXd::Constant(1, -1.0), with("lm"));
  REQUIRE(r.best.size() == 1);
  CHECK(r.best[0] == Approx(0.49).margin(1e-5));  // the bottom above x = 0.7
}

TEST_CASE("Differences of residuals are their slopes", "[unit]") {
  const LeastSquares problem = in_box(valley, -2, 2);
  for (const Eigen::Vector2d& x : {Eigen::Vector2d(0.4, 0.2), Eigen::Vector2d(2.0, -2.0)}) {
    Eigen::Matrix2d exact;
    exact << 1.0, 0.0, -2.0 * std::sqrt(10.0) * x[0], std::sqrt(10.0);
    CHECK((*slopes_at(problem, x) - exact).norm() < 1e-4);
    CHECK((*jacobian(problem, x) - exact).norm() < (x[0] < 1.0 ? 1e-9 : 1e-2));  // one-sided at a bound
  }
}

TEST_CASE("A search with too few evaluations has not converged", "[unit]") {
  for (const char* name : {"bobyqa", "lm"}) {
    const SearchResult r = minimise(in_box(valley, -2, 2), Eigen::Vector2d(-1.0, 1.0), with(name, 8));
    CHECK_FALSE(r.converged);
    CHECK_THAT(r.stop_reason, Contains("8 evaluations were not enough"));
  }
}

TEST_CASE("An exception of the objective arrives with its message", "[unit]") {
  const Residuals throwing = [](const Eigen::VectorXd& x) -> Eigen::VectorXd {
    if (x[0] != 0.0) throw std::runtime_error("the true cause");
    return valley(x);
  };
  for (const char* name : {"bobyqa", "lbfgs", "lm"})
    CHECK_THROWS_WITH(minimise(in_box(throwing, -2, 2), Eigen::Vector2d(0.0, 0.0), with(name)),
                      "the true cause");
}

TEST_CASE("An unknown algorithm is refused with the known names", "[unit]") {
  CHECK_THROWS_WITH(minimise(in_box(valley, -2, 2), Eigen::Vector2d(0.0, 0.0), with("newton")),
                    Contains("newton") && Contains("bobyqa") && Contains("lm"));
}
