#include <catch2/catch.hpp>

#include "errors/input_error.hpp"
#include "problem/free_parameters.hpp"

using namespace trunk;
using Catch::Matchers::Contains;

namespace {

Candidate healthy() {
  return {{4000.0, 28.0, 20.0, 0.8}, {}};
}

}  // namespace

TEST_CASE("coordinates and natural values go back and forth", "[unit]") {
  const SearchSpace space({"k_muscle", "k_elasticity", "damping"}, healthy());
  Candidate c = healthy();
  c.parameters.elasticity = 1234.5;
  c.parameters.muscle = 7.25;
  const Candidate back = space.decode(space.encode(c));
  CHECK(back.parameters.elasticity == Approx(1234.5).epsilon(1e-14));
  CHECK(back.parameters.muscle == Approx(7.25).epsilon(1e-14));
  CHECK(back.parameters.damping == Approx(20.0).epsilon(1e-14));
  CHECK(back.parameters.abdomen_factor == 0.8);
}

TEST_CASE("k_muscle is searched for as a ratio, so moving k_elasticity moves it along", "[unit]") {
  const SearchSpace space({"k_elasticity", "k_muscle"}, healthy());
  Eigen::VectorXd x = space.start();
  x[0] += std::log(2.0);
  CHECK(space.decode(x).parameters.muscle == Approx(56.0));
  CHECK(space.is_ratio(1));
  const Eigen::MatrixXd map = space.log_values_by_coordinates();
  const double h = 1e-6;
  for (Eigen::Index j = 0; j < 2; ++j) {
    Eigen::VectorXd ahead = space.start();
    ahead[j] += h;
    const Candidate c = space.decode(ahead), c0 = space.decode(space.start());
    CHECK(std::log(c.parameters.elasticity / c0.parameters.elasticity) / h == Approx(map(0, j)).margin(1e-6));
    CHECK(std::log(c.parameters.muscle / c0.parameters.muscle) / h == Approx(map(1, j)).margin(1e-6));
  }
}

TEST_CASE("a space that makes no sense is refused in words", "[unit]") {
  CHECK_THROWS_WITH(SearchSpace({}, healthy()), Contains("no parameter is free"));
  CHECK_THROWS_WITH(SearchSpace({"k_muscel"}, healthy()), Contains("k_muscel") && Contains("k_muscle"));
  CHECK_THROWS_WITH(SearchSpace({"damping", "damping"}, healthy()), Contains("twice"));
  Candidate outside = healthy();
  outside.parameters.damping = 0.0;
  CHECK_THROWS_WITH(SearchSpace({"damping"}, outside),
                    Contains("damping starts at 0") && Contains("0.5 to 500"));
}
