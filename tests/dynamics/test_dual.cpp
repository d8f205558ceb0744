#include "math/dual.hpp"

#include <cmath>

#include "support/allocations.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"
#include "support/trunks.hpp"

using namespace trunk;
using namespace trunk::test;

namespace {

const char* const names[] = {"elasticity",      "muscle", "damping",        "abdomen_factor",
                             "onset",           "rise",   "fast_fall",      "slow_fall",
                             "fast_fall_level", "period", "lung_elastance", "resistance"};

/// In every number of the trial but the period, by itself; the onset has no size of its own.
std::vector<Trial<double>> relative_directions(Trial<double> trial) {
  std::vector<Trial<double>> directions(9, no_change());
  for (std::size_t n = 0; n < directions.size(); ++n)
    *numbers(directions[n])[n] = std::max(*numbers(trial)[n], 0.1);
  return directions;
}

Trial<double> moved(Trial<double> trial, Trial<double> direction, double by) {
  for (std::size_t n = 0; n < numbers(trial).size(); ++n) *numbers(trial)[n] += by * *numbers(direction)[n];
  return trial;
}

double largest_of(const std::vector<double>& values) {
  double most = 0.0;
  for (double v : values) most = std::max(most, std::abs(v));
  return most;
}

}  // namespace

TEST_CASE("Every operation of a dual has the derivative of calculus", "[property][math]") {
  Random random(61);
  using D = Dual<2>;
  for (int i = 0; i < 100; ++i) {
    const double x = random.between(0.5, 2.0), y = random.between(-2.0, -0.5), h = 1e-6;
    const auto f = [](auto a, auto b) {
      using S = decltype(a);
      using std::sqrt;
      return select(a < S(1.0), sqrt(a * b * b + S(0.3)) / (a - b), -(a + b * b) * a);
    };
    const D result =
        f(D(x, Lanes<2>(Lanes<2>::Register{1.0, 0.0})), D(y, Lanes<2>(Lanes<2>::Register{0.0, 1.0})));
    if (std::abs(x - 1.0) < 2 * h) continue;
    CHECK(result.value == f(x, y));
    CHECK(in_lane(result.tangent, 0) == Approx((f(x + h, y) - f(x - h, y)) / (2 * h)).epsilon(1e-7));
    CHECK(in_lane(result.tangent, 1) == Approx((f(x, y + h) - f(x, y - h)) / (2 * h)).epsilon(1e-7));
  }
}

TEST_CASE("The derivatives of a whole breath agree with central differences", "[property][dynamics][slow]") {
  // Differences of size h = 1e-6 are wrong by h^2 and by round-off over h, 1e-16 / 1e-6, both grown by the
  // length of the breath; observed: below 2e-6. The activation's corners must lie between two steps: at a
  // corner the derivative is that of one side, the difference the mean of both.
  for (const char* name : {"healthy", "hemiparalysis_right", "published_healthy"}) {
    Scenario scenario = without_lung(name);
    scenario.activation.onset_s = 0.0005;
    scenario.activation.rise_s = 1.9993;
    const Trunk trunk = make_trunk(scenario);
    const Trial<double> trial{scenario.parameters, scenario.activation};
    const TimeGrid grid{2e-3, 4.5};
    const auto directions = relative_directions(trial);
    const VolumeDerivatives exact = simulate_volume_derivatives(trunk, trial, directions, grid);
    REQUIRE(exact.curve.ending.completed());
    CHECK(exact.curve.delta_v == simulate_volume(trunk, trial.parameters, trial.activation, grid).delta_v);
    const double h = 1e-6;
    std::vector<Trial<double>> around;
    for (const auto& direction : directions)
      for (const double by : {h, -h}) around.push_back(moved(trial, direction, by));
    const auto curves = simulate_volumes(trunk, around, grid);
    for (std::size_t n = 0; n < directions.size(); ++n) {
      double apart = 0.0;
      for (std::size_t step = 0; step < exact.curve.delta_v.size(); ++step) {
        const double difference = (curves[2 * n].delta_v[step] - curves[2 * n + 1].delta_v[step]) / (2 * h);
        apart = std::max(apart, std::abs(difference - exact.along[n].delta_v[step]));
      }
      const double size = largest_of(exact.along[n].delta_v);
      CAPTURE(name, names[n], size, apart);
      CHECK(size > 1e-6);
      CHECK(apart < 1e-5 * size);
    }
  }
}

TEST_CASE("Derivatives pass through the breaths before", "[property][dynamics][slow]") {
  Scenario scenario = without_lung("hemiparalysis_right");
  scenario.time = {2e-3, 2.0, Damping::implicit, Start::periodic};
  scenario.activation.onset_s = -0.2005;  // so that every breath cuts the activation of the one before
  scenario.activation.rise_s = 0.7993;
  const Trunk trunk = make_trunk(scenario);
  const Trial<double> trial{scenario.parameters, scenario.activation};
  const auto directions = relative_directions(trial);
  const VolumeDerivatives exact = simulate_volume_derivatives(trunk, trial, directions, scenario.time);
  REQUIRE(exact.curve.ending.completed());
  REQUIRE(exact.curve.above_relaxation != 0.0);
  const double h = 1e-6;
  for (std::size_t n = 0; n < directions.size(); ++n) {
    const auto curve = [&](double by) {
      const Trial<double> there = moved(trial, directions[n], by);
      return simulate_volume(trunk, there.parameters, there.activation, scenario.time);
    };
    const VolumeCurve more = curve(h), less = curve(-h);
    double apart = 0.0;
    for (std::size_t step = 0; step < more.delta_v.size(); ++step)
      apart = std::max(apart, std::abs((more.delta_v[step] - less.delta_v[step]) / (2 * h) -
                                       exact.along[n].delta_v[step]));
    const double size = largest_of(exact.along[n].delta_v);
    CAPTURE(names[n], size, apart);
    CHECK(size > 1e-6);
    CHECK(apart < 1e-5 * size);
    const double level = (more.above_relaxation - less.above_relaxation) / (2 * h);
    CHECK(exact.above_relaxation[n] == Approx(level).margin(1e-5 * size));
  }
}

TEST_CASE("Derivatives pass through loads, friction, moving ribs and free bodies",
          "[property][dynamics][long]") {
  for (const Scenario& scenario : {laden("healthy"), on_sheet(laden("healthy"))}) {
    const Trunk trunk = make_trunk(scenario);
    const Trial<double> trial{scenario.parameters, scenario.activation};
    const TimeGrid grid{1e-3, 0.2};
    const auto directions = relative_directions(trial);
    const VolumeDerivatives exact = simulate_volume_derivatives(trunk, trial, directions, grid);
    REQUIRE(exact.curve.ending.completed());
    const double h = 1e-6;
    for (std::size_t n : {0u, 1u, 2u, 3u}) {
      const auto volume = [&](double by) {
        const Trial<double> t = moved(trial, directions[n], by);
        return simulate_volume(trunk, t.parameters, t.activation, grid).delta_v.back();
      };
      CAPTURE(names[n]);
      CHECK(exact.along[n].delta_v.back() == Approx((volume(h) - volume(-h)) / (2 * h)).epsilon(1e-3));
    }
  }
}

TEST_CASE("Derivatives pass through lung and airway", "[property][dynamics][slow]") {
  Scenario quiet = breathing_air();
  quiet.time.dt_s = 5e-3;
  quiet.activation.onset_s = 0.0005;
  quiet.activation.rise_s = 1.9993;
  Scenario rubbing = laden_with_lung("hemiparalysis_right");
  rubbing.time = {1e-3, 0.2};
  for (const Scenario& scenario : {quiet, rubbing}) {
    const Trunk trunk = make_trunk(scenario);
    const Trial<double> trial{scenario.parameters, scenario.activation};
    std::vector<Trial<double>> directions;
    for (const std::size_t n : {0u, 1u, 2u, 3u, 10u, 11u}) {
      Trial<double> own = trial;
      directions.push_back(no_change());
      *numbers(directions.back())[n] = *numbers(own)[n];
    }
    const VolumeDerivatives exact = simulate_volume_derivatives(trunk, trial, directions, scenario.time);
    REQUIRE(exact.curve.ending.completed());
    const double h = 1e-6, bound = scenario.pleura.airway_pressure.empty() ? 1e-5 : 1e-3;
    for (std::size_t n = 0; n < directions.size(); ++n) {
      const auto curve = [&](double by) {
        const Trial<double> there = moved(trial, directions[n], by);
        return simulate_volume(trunk, there.parameters, there.activation, scenario.time).delta_v;
      };
      const std::vector<double> more = curve(h), less = curve(-h);
      double apart = 0.0;
      for (std::size_t step = 0; step < more.size(); ++step)
        apart = std::max(apart, std::abs((more[step] - less[step]) / (2 * h) - exact.along[n].delta_v[step]));
      const double size = largest_of(exact.along[n].delta_v);
      CAPTURE(scenario.title, n, size, apart);
      CHECK(size > 1e-7);
      CHECK(apart < bound * size);
    }
  }
}

TEST_CASE("A step of duals allocates nothing", "[property][dynamics]") {
  const Scenario scenario = laden_with_lung("healthy");
  const Model model = make_trunk(scenario).model;
  const Trial<double> alone{scenario.parameters, scenario.activation};
  const auto directions = relative_directions(alone);
  const auto trial = with_tangents<2>(alone, std::span(directions).first(2));
  auto state = rest_state<Dual<2>>(model);
  auto workspace = make_workspace(model, trial.parameters, 1e-3);
  bool ok = true;
  const long before = allocations();
  for (int n = 0; n < 200; ++n)
    ok = step(model, trial.parameters, trial.activation(state.time_s), state, workspace).ok && ok;
  const long during = allocations() - before;
  CHECK(ok);
  CHECK(during == 0);
}

TEST_CASE("Every instruction set gives the same bits", "[property][dynamics]") {
  for (const Scenario& scenario : {laden("hemiparalysis_right"), on_sheet(laden("hemiparalysis_right")),
                                   laden_with_lung("hemiparalysis_right")}) {
    const Model model = make_trunk(scenario).model;
    const TimeGrid grid{1e-3, 0.15};
    std::vector<Trial<double>> trials(8, {scenario.parameters, scenario.activation});
    for (std::size_t i = 0; i < trials.size(); ++i)
      trials[i].parameters.muscle *= 1.0 + static_cast<double>(i);
    const auto directions = relative_directions(trials[0]);
    VolumeCurve first;
    BreathCurves first_derivative;
    CHECK(kernels().front()->lanes == 2);
    for (const Kernel* k : kernels()) {
      INFO(k->instruction_set);
      const auto lanes = static_cast<std::size_t>(k->lanes), tangents = static_cast<std::size_t>(k->tangents);
      std::vector<VolumeCurve> together(lanes);
      k->volume_curves(model, std::span(trials).first(lanes), grid, together);
      for (std::size_t i = 0; i < lanes; ++i) {
        VolumeCurve alone;
        k->volume_curve(model, std::span(trials).subspan(i, 1), grid, {&alone, 1});
        REQUIRE(alone.ending.completed());
        for (const auto values : all_curves) CHECK(alone.*values == together[i].*values);
      }
      VolumeCurve curve;
      std::vector<BreathCurves> derivatives(tangents);
      k->volume_derivatives(model, trials[0], std::span(directions).first(tangents), grid, curve,
                            derivatives);
      CHECK(curve.delta_v == together[0].delta_v);
      if (k == kernels().front()) {
        first = together[0];
        first_derivative = derivatives[1];
      }
      CHECK(together[0].delta_v == first.delta_v);
      for (const auto values : all_curves) CHECK(derivatives[1].*values == first_derivative.*values);
    }
    const VolumeCurve here = [&] {  // as compiled for this test
      VolumeCurve curve;
      calc_volume_curves<double>(model, std::span(trials).first(1), grid, {&curve, 1});
      return curve;
    }();
    CHECK(here.delta_v == first.delta_v);
  }
}
