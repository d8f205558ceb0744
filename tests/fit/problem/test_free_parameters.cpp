#include <set>

#include "errors/input_error.hpp"
#include "math/units.hpp"
#include "problem/search_space.hpp"
#include "scenarios/keys.hpp"
#include "support/catch.hpp"

using namespace trunk;

namespace {

Candidate healthy() {
  Candidate c{{4000.0, 28.0, 20.0, 0.8}, {}};
  c.parameters.lung_elastance = 5.0 * Pa_per_cmH2O / m3_per_litre;
  c.parameters.resistance = 2.5 * Pa_per_cmH2O / m3_per_litre;
  return c;
}

}  // namespace

TEST_CASE("Coordinates and natural values go back and forth, for every parameter there is", "[unit]") {
  std::vector<std::string> all;
  for (const FreeParameter& p : free_parameters()) all.emplace_back(p.name);
  const SearchSpace space(all, healthy());
  Candidate c = healthy();
  double value = 0.3;
  for (const FreeParameter& p : free_parameters())
    set_value(p, p.lower + (p.upper - p.lower) * (value *= 0.9), c);
  const Candidate back = space.decode(space.encode(c));
  for (const FreeParameter& p : free_parameters()) {
    INFO(p.name);
    CHECK(value_of(p, back) == Approx(value_of(p, c)).epsilon(1e-12));
  }
  CHECK(space.decode(space.start()).parameters.abdomen_factor == Approx(0.8));
}

TEST_CASE("Bounds lie inside what a scenario may say, and the healthy scenario inside the bounds", "[unit]") {
  const Candidate c = healthy();
  for (const FreeParameter& p : free_parameters()) {
    INFO(p.name);
    const auto keys = scenario_keys();
    const auto key =
        std::find_if(keys.begin(), keys.end(), [&](const auto& k) { return k.path == p.scenario_key; });
    REQUIRE(key != keys.end());
    const auto& number = std::get<ScenarioKey::Number>(key->kind);
    if (p.name != "onset") CHECK(number.low <= p.lower);
    CHECK(p.upper <= number.high);
    CHECK(p.lower < value_of(p, c));
    CHECK(value_of(p, c) < p.upper);
  }
}

TEST_CASE("A search changes k_muscle together with k_elasticity, because its coordinate is a ratio",
          "[unit]") {
  const SearchSpace space({"k_elasticity", "k_muscle", "onset"}, healthy());
  Eigen::VectorXd x = space.start();
  x[0] += std::log(2.0);
  CHECK(space.decode(x).parameters.muscle == Approx(56.0));
  CHECK(space.is_ratio(1));
  const Eigen::MatrixXd map = space.values_by_coordinates();
  const double h = 1e-6;
  for (Eigen::Index j = 0; j < 3; ++j) {
    Eigen::VectorXd ahead = space.start();
    ahead[j] += h;
    const Candidate c = space.decode(ahead), c0 = space.decode(space.start());
    CHECK(std::log(c.parameters.elasticity / c0.parameters.elasticity) / h == Approx(map(0, j)).margin(1e-6));
    CHECK(std::log(c.parameters.muscle / c0.parameters.muscle) / h == Approx(map(1, j)).margin(1e-6));
    CHECK((c.activation.onset_s - c0.activation.onset_s) / h == Approx(map(2, j)).margin(1e-6));
  }
}

TEST_CASE("Group names stand for several parameters", "[unit]") {
  const auto timing = parameter_names({"timing"}), shape = parameter_names({"k_muscle", "shape"});
  CHECK(std::set<std::string>(timing.begin(), timing.end()) ==
        std::set<std::string>{"onset", "rise", "fast_fall", "slow_fall"});
  CHECK(shape.size() == 1 + ShapeKnots::count);
  CHECK_THROWS_WITH(parameter_names({"strength"}),
                    Contains("'strength'") && Contains("k_muscle") && Contains("shape"));
}

TEST_CASE("Nuisance parameters come after those asked for, and only once", "[unit]") {
  const SearchSpace space({"k_muscle", "rise"}, healthy(), {"onset", "rise", "slow_fall"});
  REQUIRE(space.size() == 4);
  CHECK(space.asked_for() == 2);
  CHECK(space.parameter(1).name == "rise");
  CHECK(space.find("onset") == 2u);
  CHECK_FALSE(space.find("damping"));
}

TEST_CASE("Priors are residuals of deviation one about their mean", "[unit]") {
  const SearchSpace space(
      {"k_elasticity", "k_muscle", "onset", "shape_rise_5"}, healthy(), {},
      {{"k_elasticity", 5000.0, std::log(1.5)}, {"k_muscle", {}, 0.2}, {"onset", {}, 0.0}});
  Candidate c = healthy();
  c.parameters.elasticity = 5000.0 * 1.5;
  c.parameters.muscle = 28.0 * std::exp(-0.4);
  c.activation.onset_s = 0.5;  // its prior was taken away
  c.activation.shape[4] = std::exp(0.3);
  const Eigen::VectorXd r = space.prior_residuals(space.encode(c));
  // k_elasticity one deviation up, k_muscle two down, the knot 0.3 of its 1, then 5 bends: 3 in the rise.
  REQUIRE(r.size() == 3 + 4 + 1 + 2);
  CHECK(r[0] == Approx(1.0));
  CHECK(r[1] == Approx(-2.0));
  CHECK(r[2] == Approx(0.3));
  CHECK(r[3] == Approx(0.0).margin(1e-12));
  CHECK(r[5] == Approx(1.0));   // knot 5 ends the bend about knot 4
  CHECK(r[6] == Approx(-2.0));  // and is the middle of its own
  CHECK(space.prior_residuals(space.start()).tail(7).norm() == Approx(0.0).margin(1e-12));
}

TEST_CASE("A search space that makes no sense is refused with a reason", "[unit]") {
  CHECK_THROWS_WITH(SearchSpace({}, healthy()), Contains("no parameter is free"));
  CHECK_THROWS_WITH(SearchSpace({"k_muscel"}, healthy()), Contains("k_muscel") && Contains("k_muscle"));
  CHECK_THROWS_WITH(SearchSpace({"damping", "damping"}, healthy()), Contains("twice"));
  Candidate outside = healthy();
  outside.parameters.damping = 0.0;
  CHECK_THROWS_WITH(SearchSpace({"damping"}, outside),
                    Contains("damping starts at 0") && Contains("0.5 to 500"));
  CHECK_THROWS_WITH(SearchSpace({"damping"}, healthy(), {}, {{"damping", 5000.0, 0.1}}), Contains("5000"));
  CHECK_THROWS_WITH(SearchSpace({"damping"}, healthy(), {}, {{"k_muscle", {}, 0.1}}), Contains("not fitted"));
}
