#include <catch2/catch.hpp>

#include <cstdint>

#include "estimation/estimate.hpp"
#include "support/trunks.hpp"

using namespace trunk;
using Catch::Matchers::Contains;

namespace {

/// A trace made by the simulator itself at half the time step, without noise.
Target twin(const Trunk& trunk, const Scenario& s, Parameters<double> truth) {
  TimeGrid fine = s.time;
  fine.dt_s *= 0.5;
  const VolumeCurve curve = simulate_volume(trunk, truth, s.activation, fine);
  REQUIRE(curve.summary.completed());
  Target target;
  for (int i = 0; i <= 200; ++i) target.time_s.push_back(s.time.duration_s * i / 200);
  const Eigen::VectorXd v = sampled(curve.delta_v, fine.dt_s, target.time_s);
  target.delta_v.assign(v.data(), v.data() + v.size());
  return target;
}

Scenario healthy_scenario() {
  return test::shipped("healthy");
}

}  // namespace

TEST_CASE("a twin at half the step gives its parameters back to 1e-3 from ten starts", "[regression][slow]") {
  const Scenario s = healthy_scenario();
  const Trunk trunk = make_trunk(s);
  Parameters<double> truth = s.parameters;
  truth.elasticity = 5200.0;
  truth.muscle = 44.0;
  const Target target = twin(trunk, s, truth);
  double worst = 0.0;
  for (int k = 0; k < 10; ++k) {
    Candidate start{s.parameters, s.activation};
    start.parameters.elasticity = 600.0 * std::pow(15000.0 / 600.0, k / 9.0);
    start.parameters.muscle = start.parameters.elasticity * (k % 2 == 0 ? 0.002 : 0.04);
    const SearchSpace space({"k_elasticity", "k_muscle"}, start);
    const Estimation e = estimate(trunk, s, space, target, {});
    INFO("start " << start.parameters.elasticity << ", " << start.parameters.muscle);
    CHECK(e.search.converged);
    CHECK(e.best.parameters.elasticity == Approx(5200.0).epsilon(1e-3));
    CHECK(e.best.parameters.muscle == Approx(44.0).epsilon(1e-3));
    worst = std::max(worst, std::abs(e.best.parameters.elasticity / 5200.0 - 1.0));
  }
  WARN("largest relative error of k_elasticity from ten starts: " << worst);
}

TEST_CASE("a tidal volume alone is met exactly, without uncertainty", "[regression][slow]") {
  const Scenario s = healthy_scenario();
  const Trunk trunk = make_trunk(s);
  const SearchSpace space({"k_muscle"}, {s.parameters, s.activation});
  const Estimation e = estimate(trunk, s, space, {{}, {600e-6}}, {});
  REQUIRE(e.search.converged);
  CHECK(e.model[0] == Approx(600e-6).epsilon(1e-4));
  REQUIRE(e.uncertainty);
  CHECK(std::isnan(e.uncertainty->parameters[0].stderr_));
  CHECK_THAT(e.uncertainty->verdict, Contains("no uncertainty"));
}

TEST_CASE("a slow breath with noise determines the ratio and says so", "[regression][slow]") {
  Scenario s = healthy_scenario();
  s.parameters.damping = 2.0;  // hardly any lag: k_elasticity by itself leaves no trace
  const Trunk trunk = make_trunk(s);
  Target target = twin(trunk, s, s.parameters);
  std::uint32_t state = 1;  // correlated noise, as residuals of real breaths are, the same everywhere
  double noise = 0.0;
  for (double& v : target.delta_v) {
    state = state * 1664525u + 1013904223u;
    noise = 0.95 * noise + 0.14 * 466e-6 * (state / 4294967296.0 - 0.5);
    v += noise;
  }
  const SearchSpace space({"k_elasticity", "k_muscle"}, {s.parameters, s.activation});
  const Estimation e = estimate(trunk, s, space, target, {});
  REQUIRE(e.uncertainty);
  CAPTURE(e.uncertainty->verdict);
  CHECK_FALSE(e.uncertainty->identifiable);
  CHECK(e.uncertainty->ratio.identifiable);
  CHECK(e.uncertainty->ratio.value == Approx(s.parameters.muscle / s.parameters.elasticity).epsilon(0.05));
  CHECK_THAT(e.uncertainty->verdict, Contains("Only the ratio is determined"));
}

TEST_CASE("runs that fail are counted, and the fit goes on", "[regression][slow]") {
  Scenario s = healthy_scenario();
  s.time.dt_s = 4e-3;  // stable at 4000 N/m, not at the upper bound
  const Trunk trunk = make_trunk(s);
  const Target target = twin(trunk, s, s.parameters);
  const SearchSpace space({"k_elasticity", "k_muscle"}, {s.parameters, s.activation});
  Objective objective(trunk, s.time, space, target);
  const double at_truth = objective(space.start());
  const double beyond = objective(space.upper());
  CHECK(finite(beyond));
  CHECK(beyond > 1e3 * std::max(at_truth, 1e-12));
  CHECK(objective.failures() == 1);
  REQUIRE(objective.best());
  CHECK(objective.best()->objective == at_truth);
  const Estimation e = estimate(trunk, s, space, target, {});
  CHECK(e.best.parameters.elasticity == Approx(s.parameters.elasticity).epsilon(0.02));
}
