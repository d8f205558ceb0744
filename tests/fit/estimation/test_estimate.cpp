#include <cstdint>

#include "estimation/estimate.hpp"
#include "estimation/start.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"
#include "support/trunk_objective.hpp"
#include "support/trunks.hpp"

using namespace trunk;

namespace {

/// A trace made by the simulator itself at half the time step, without noise.
MeasuredCurve twin(const Trunk& trunk, const Scenario& s, Parameters<double> truth) {
  TimeGrid fine = s.time;
  fine.dt_s *= 0.5;
  const VolumeCurve curve = simulate_volume(trunk, truth, s.activation, fine);
  REQUIRE(curve.ending.completed());
  MeasuredCurve measured;
  for (int i = 0; i <= 200; ++i) measured.time_s.push_back(s.time.duration_s * i / 200);
  const Eigen::VectorXd v = sampled(curve.delta_v, fine.dt_s, measured.time_s);
  measured.delta_v.assign(v.data(), v.data() + v.size());
  return measured;
}

EstimationOptions quick() {
  EstimationOptions options;
  options.profiles = false;
  options.surface_points = 0;
  return options;
}

Estimation fitted(const Trunk& trunk, const Scenario& s, const SearchSpace& space,
                  const MeasuredCurve& measured, const EstimationOptions& options = quick()) {
  Ledger ledger;
  const TrunkAsCompartment compartment = test::compartment_of(trunk, s.parameters);
  return estimate({trunk, s.time, space, measured, compartment, s.parameters}, options, ledger);
}

Scenario healthy_scenario() {
  return test::without_lung("healthy");
}

}  // namespace

TEST_CASE("A twin at half the step gives its parameters back to 1e-3 from ten starts", "[nightly][slow]") {
  const Scenario s = healthy_scenario();
  const Trunk trunk = make_trunk(s);
  Parameters<double> truth = s.parameters;
  truth.elasticity = 5200.0;
  truth.muscle = 44.0;
  const MeasuredCurve measured = twin(trunk, s, truth);
  double worst = 0.0;
  for (int k = 0; k < 10; ++k) {
    Candidate start{s.parameters, s.activation};
    start.parameters.elasticity = 600.0 * std::pow(15000.0 / 600.0, k / 9.0);
    start.parameters.muscle = start.parameters.elasticity * (k % 2 == 0 ? 0.002 : 0.04);
    const SearchSpace space({"k_elasticity", "k_muscle"}, start);
    const Estimation e = fitted(trunk, s, space, measured);
    INFO("start " << start.parameters.elasticity << ", " << start.parameters.muscle);
    CHECK(e.search.converged);
    CHECK(e.best.parameters.elasticity == Approx(5200.0).epsilon(1e-3));
    CHECK(e.best.parameters.muscle == Approx(44.0).epsilon(1e-3));
    worst = std::max(worst, std::abs(e.best.parameters.elasticity / 5200.0 - 1.0));
  }
  WARN("largest relative error of k_elasticity from ten starts: " << worst);
}

TEST_CASE("A tidal volume alone is met exactly, without uncertainty", "[regression][slow]") {
  const Scenario s = healthy_scenario();
  const Trunk trunk = make_trunk(s);
  const SearchSpace space({"k_muscle"}, {s.parameters, s.activation});
  const Estimation e = fitted(trunk, s, space, {{}, {600e-6}, {}});
  REQUIRE(e.search.converged);
  CHECK(e.model[0] == Approx(600e-6).epsilon(1e-4));
  REQUIRE(e.uncertainty);
  CHECK(std::isnan(e.uncertainty->parameters[0].stderr_));
}

TEST_CASE("A slow breath with noise determines the ratio and says so", "[regression][slow]") {
  Scenario s = healthy_scenario();
  s.parameters.damping = 2.0;  // hardly any lag: k_elasticity by itself leaves no trace
  const Trunk trunk = make_trunk(s);
  MeasuredCurve measured = twin(trunk, s, s.parameters);
  std::uint32_t state = 1;  // correlated noise, as residuals of real breaths are, the same everywhere
  double noise = 0.0;
  for (double& v : measured.delta_v) {
    state = state * 1664525u + 1013904223u;
    noise = 0.95 * noise + 0.14 * 466e-6 * (state / 4294967296.0 - 0.5);
    v += noise;
  }
  const SearchSpace space({"k_elasticity", "k_muscle"}, {s.parameters, s.activation});
  const Estimation e = fitted(trunk, s, space, measured);
  REQUIRE(e.uncertainty);
  const Estimate& elasticity = e.uncertainty->parameters.front();
  CAPTURE(elasticity.value, elasticity.lower95, elasticity.upper95);
  CHECK_FALSE(e.uncertainty->identifiable);
  CHECK(e.uncertainty->ratio.identifiable);
  CHECK(e.uncertainty->ratio.value == Approx(s.parameters.muscle / s.parameters.elasticity).epsilon(0.05));
}

TEST_CASE("Runs that fail are counted, and the fit continues", "[regression][slow]") {
  Scenario s = healthy_scenario();
  s.time.dt_s = 4e-3;  // stable at 4000 N/m, not at the upper bound: there it is simulated in steps of 1 ms
  const Trunk trunk = make_trunk(s);
  const MeasuredCurve measured = twin(trunk, s, s.parameters);
  const SearchSpace space({"k_elasticity", "k_muscle"}, {s.parameters, s.activation});
  Ledger ledger;
  test::TrunkObjective objective(trunk, s.time, space, measured, ledger);
  const double at_truth = objective->problem().at(space.start()).objective;
  const double too_stiff = objective->problem().at(space.upper()).objective;
  CHECK(finite(too_stiff));
  CHECK(objective->failures() == 0);
  Eigen::VectorXd far = space.start();
  far[0] = std::log(1e8);  // too stiff for 1 ms as well
  const double beyond = objective->problem().at(far).objective;
  CHECK(finite(beyond));
  CHECK(beyond > 1e3 * std::max(at_truth, 1e-12));
  CHECK(objective->failures() == 1);
  const Estimation e = fitted(trunk, s, space, measured);
  CHECK(e.best.parameters.elasticity == Approx(s.parameters.elasticity).epsilon(0.02));
}

TEST_CASE("One start of the timing misses the best optimum of some breaths, and twelve miss few",
          "[unit][fit]") {
  const TrunkAsCompartment compartment{25.0, 0.0726, 0.0726, 25.0};
  test::Random random(7);
  int one_misses = 0, twelve_miss = 0;
  constexpr int breaths = 40;
  for (int k = 0; k < breaths; ++k) {
    TimeGrid grid{4e-3, random.between(2.0, 6.0)};
    grid.start = Start::periodic;
    const double inspiration_s = random.between(0.3, 0.45) * grid.duration_s,
                 expiration_s = grid.duration_s - inspiration_s;
    Parameters<double> p{25.0 * 20.0 / random.between(0.15, 0.9), 0.0, 20.0, 1.0};
    p.muscle = 0.0075 * p.elasticity;
    BreathActivation<double> a{.onset_s = random.between(-0.1, 0.0),
                               .rise_s = inspiration_s,
                               .fast_fall_s = random.between(0.05, 0.5) * expiration_s,
                               .slow_fall_s = random.between(0.2, 0.9) * expiration_s,
                               .fast_fall_level = random.between(0.1, 0.8)};
    for (double& knot : a.shape) knot = random.between(0.85, 1.15);  // muscles do not follow straight lines
    MeasuredCurve measured;
    for (int i = 0; i < 200; ++i) measured.time_s.push_back(grid.duration_s * i / 199);
    measured.delta_v = compartment_breath(compartment.of(p), a, grid, measured.time_s).delta_v;
    MeasuredBreath breath;
    breath.inspiration_s = inspiration_s;
    breath.duration_s = grid.duration_s;
    const Candidate begin{{4000.0, 30.0, 20.0, 1.0}, activation_from_landmarks(breath)};
    CompartmentFit fit{compartment,
                       grid,
                       measured,
                       {"k_elasticity", "k_muscle"},
                       {"onset", "rise", "fast_fall", "slow_fall", "fast_fall_level"},
                       {}};
    const auto best_of = [&](int starts) {
      fit.starts = starts;
      const auto all = compartment_searches(fit, begin);
      REQUIRE(static_cast<int>(all.size()) == starts);
      for (std::size_t i = 1; i < all.size(); ++i) CHECK(all[i - 1].objective <= all[i].objective);
      return all.front().objective;
    };
    const double one = best_of(1), twelve = best_of(12), lowest = std::min(best_of(60), twelve);
    CHECK(twelve == best_of(12));  // seeded
    one_misses += one > 1.05 * lowest;
    twelve_miss += twelve > 1.05 * lowest;
  }
  CAPTURE(one_misses, twelve_miss);
  CHECK(one_misses >= 3);  // 5 were seen: otherwise these breaths show nothing
  CHECK(twelve_miss <= 0.1 * breaths);
}

TEST_CASE("A robust loss ignores an outlier that least squares follows", "[regression][slow]") {
  Scenario s = healthy_scenario();
  s.time.dt_s = 4e-3;
  const Trunk trunk = make_trunk(s);
  MeasuredCurve measured = twin(trunk, s, s.parameters);
  for (std::size_t i = 60; i < 75; ++i) measured.delta_v[i] += 120e-6;  // a swallow
  const SearchSpace space({"k_elasticity", "k_muscle"}, {s.parameters, s.activation});
  const auto error_with = [&](Loss loss) {
    EstimationOptions options = quick();
    options.loss = loss;
    return std::abs(fitted(trunk, s, space, measured, options).best.parameters.elasticity /
                        s.parameters.elasticity -
                    1.0);
  };
  const double squares = error_with(Loss::squares);
  CAPTURE(squares);
  CHECK(squares > 0.05);
  CHECK(error_with(Loss::huber) < 0.2 * squares);
  CHECK(error_with(Loss::student) < 0.1 * squares);
}
