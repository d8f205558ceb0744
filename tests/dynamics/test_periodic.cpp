#include <cmath>

#include "dynamics/recoil.hpp"
#include "support/catch.hpp"
#include "support/trunks.hpp"

using namespace trunk;
using namespace trunk::test;

namespace {

/// A shipped scenario whose breaths repeat every period_s, with the recoil time tau_s.
Scenario breathing(const std::string& name, double period_s, double tau_s = 0.121) {
  Scenario s = without_lung(name);
  s.time.start = Start::periodic;
  s.time.duration_s = period_s;
  const double ratio = s.parameters.muscle / s.parameters.elasticity;
  s.parameters.elasticity = 24.2 * s.parameters.damping / tau_s;
  s.parameters.muscle = ratio * s.parameters.elasticity;
  BreathActivation<double>& a = s.activation;
  a.rise_s = 0.4 * period_s;
  a.fast_fall_s = 0.1 * period_s;
  a.slow_fall_s = 0.4 * period_s;
  return s;
}

VolumeCurve curve_of(const Trunk& trunk, const Scenario& s) {
  return simulate_volume(trunk, s.parameters, s.activation, s.time);
}

/// Returns the volume above rest.
std::vector<double> gains_of(const VolumeCurve& curve) {
  std::vector<double> gains = curve.delta_v;
  for (double& v : gains) v += curve.above_relaxation;
  return gains;
}

double span_of(const std::vector<double>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return *high - *low;
}

/// Returns the largest distance of a periodic breath from the last of many breaths from rest, over its tidal
/// volume.
double distance_from_limit(const Scenario& s) {
  const Trunk trunk = make_trunk(s);
  const VolumeCurve breath = curve_of(trunk, s);
  REQUIRE(breath.ending.completed());
  Scenario many = s;
  const double cycles = std::ceil(3.0 * lead_s(trunk.model, s.parameters) / s.time.duration_s);
  many.time.start = Start::rest;
  many.time.duration_s = (cycles + 1.0) * s.time.duration_s;
  many.activation.period_s = s.time.duration_s;
  const VolumeCurve all = curve_of(trunk, many);
  REQUIRE(all.ending.completed());
  const std::size_t first = all.delta_v.size() - breath.delta_v.size();
  const std::vector<double> gains = gains_of(breath);
  double apart = 0.0;
  for (std::size_t n = 0; n < gains.size(); ++n)
    apart = std::max(apart, std::abs(gains[n] - all.delta_v[first + n]));
  return apart / span_of(gains);
}

/// Returns V of tau V' + V = gain A(t) at each step of breathing that repeats: exact for an activation that
/// is constant within a step.
std::vector<double> one_compartment(double tau_s, double gain, const Scenario& s) {
  const double decay = std::exp(-s.time.dt_s / tau_s);
  std::vector<double> v{0.0};
  for (int n = 0; n < s.time.steps(); ++n)
    v.push_back(decay * v.back() +
                (1.0 - decay) * gain * s.time.active(s.activation, (n + 0.5) * s.time.dt_s));
  const double start = v.back() / (1.0 - std::exp(-s.time.duration_s / tau_s));
  for (std::size_t n = 0; n < v.size(); ++n)
    v[n] += start * std::exp(-static_cast<double>(n) * s.time.dt_s / tau_s);
  return v;
}

}  // namespace

TEST_CASE("A breath that repeats is the limit of many breaths from rest", "[property][dynamics][slow]") {
  for (const auto& [period_s, tau_s] : {std::pair{1.5, 1.2}, {3.0, 0.35}, {6.0, 0.16}}) {
    CAPTURE(period_s, tau_s);
    CHECK(distance_from_limit(breathing("healthy", period_s, tau_s)) < 1e-4);
  }
  // Sides that sway for longer than the volume lasts, another shape, and an abdomen of another stiffness.
  CHECK(distance_from_limit(breathing("hemiparalysis_right", 3.0)) < 1e-4);
  CHECK(distance_from_limit(breathing("craighero", 3.0)) < 1e-4);
  for (const double factor : {0.3, 3.0}) {
    Scenario s = breathing("healthy", 3.0);
    s.parameters.abdomen_factor = factor;
    CHECK(distance_from_limit(s) < 1e-4);
  }
}

TEST_CASE("Breaths of all periods and recoil times that occur repeat", "[nightly][dynamics]") {
  double farthest = 0.0;
  for (const char* name : {"healthy", "hemiparalysis_right", "craighero"})
    for (const double tau_s : {0.16, 0.25, 0.35, 0.5, 0.64, 0.9, 1.2})
      for (const double period_s : {1.5, 2.0, 3.0, 4.5, 6.0}) {
        CAPTURE(name, tau_s, period_s);
        const double apart = distance_from_limit(breathing(name, period_s, tau_s));
        CHECK(apart < 1e-4);
        farthest = std::max(farthest, apart);
      }
  WARN("breaths that repeat are within " << farthest << " of a tidal volume of many breaths from rest");
}

TEST_CASE("With a lung, a breath that repeats is the limit of many breaths too",
          "[property][dynamics][slow]") {
  constexpr double per_L = Pa_per_cmH2O / m3_per_litre;
  for (const auto& [resistance, elastance, cpap] :
       {std::tuple{0.0, 20.0, 0.0}, {10.0, 0.0, 0.0}, {10.0, 20.0, 0.0}, {2.75, 5.0, 10.0}}) {
    Scenario s = breathing_air();
    s.time = {5e-3, 3.0, Damping::implicit, Start::periodic};
    s.activation.rise_s = 1.0;
    s.activation.slow_fall_s = 1.0;
    s.parameters.resistance = resistance * per_L;
    s.parameters.lung_elastance = elastance * per_L;
    s.pleura.airway_pressure = PiecewiseLinear({{0.0, cpap * Pa_per_cmH2O}}, cpap * Pa_per_cmH2O);
    const double apart = distance_from_limit(s);
    CAPTURE(resistance, elastance, cpap);
    CHECK(apart < 5e-5);
    WARN("R " << resistance << ", E " << elastance << ", airway " << cpap << ": " << apart);
  }
}

TEST_CASE("A breath ends where it began, and its volume above relaxation is positive",
          "[property][dynamics][slow]") {
  const Scenario s = breathing("healthy", 2.0, 0.5);
  const Trunk trunk = make_trunk(s);
  const BreathRun run = run_breath(trunk, s, 100);
  REQUIRE(run.ending.completed());
  CHECK(run.delta_v.front() == 0.0);
  CHECK(std::abs(run.delta_v.back()) < 1e-4 * run.measures.delta_v);
  CHECK(run.above_relaxation > 0.05 * run.measures.delta_v);
  CHECK(run.time_s.front() == 0.0);
  CHECK(run.time_s.size() == static_cast<std::size_t>(s.time.steps()) + 1);
  CHECK(run.frames.front().step == 0);
  // Measures refer to the shape at t = 0, not to rest.
  const Shape rest = shape_of(trunk, trunk.model.rest), start = shape_of(trunk, run.start);
  CHECK(start.lung_volume - rest.lung_volume == Approx(run.above_relaxation).epsilon(1e-9));
  CHECK(run.measures.end_expiratory_volume == start.lung_volume);
  CHECK(run.measures.delta_v == Approx(*std::max_element(run.delta_v.begin(), run.delta_v.end())));
  const VolumeCurve curve = curve_of(trunk, s);
  CHECK(curve.delta_v == run.delta_v);
  CHECK(curve.above_relaxation == run.above_relaxation);
}

TEST_CASE("Breathing that repeats is that of one compartment with the measured recoil",
          "[property][dynamics][slow]") {
  const Model model = make_trunk(without_lung("healthy")).model;
  const Parameters<double> usual = without_lung("healthy").parameters;
  const Recoil recoil = measure_recoil(model, usual);
  CHECK(recoil.time_factor == Approx(25.1).margin(0.3));
  CHECK(recoil.gain == Approx(72.5e-3).epsilon(0.01));
  for (const auto& [period_s, tau_s, bound] :
       {std::tuple{2.0, 0.3, 8e-3}, {3.3, 0.3, 5e-3}, {5.0, 0.121, 3e-3}, {5.0, 0.6, 5e-3}}) {
    Scenario s = breathing("healthy", period_s, tau_s);
    s.time.damping = Damping::centred;  // of second order
    const std::vector<double> gains = gains_of(curve_of(make_trunk(s), s));
    const Parameters<double>& p = s.parameters;
    const std::vector<double> expected = one_compartment(recoil.time_factor * p.damping / p.elasticity,
                                                         recoil.gain * p.muscle / p.elasticity, s);
    double squares = 0.0;
    for (std::size_t n = 0; n < gains.size(); ++n) squares += std::pow(gains[n] - expected[n], 2);
    const double nrmse = std::sqrt(squares / static_cast<double>(gains.size())) / span_of(gains);
    CAPTURE(period_s, tau_s, nrmse);
    CHECK(nrmse < bound);
    WARN("one compartment is within " << 100 * nrmse << " % at " << period_s << " s, recoil time " << tau_s);
  }
}

TEST_CASE("The recoil does not depend on parameters, mass or step", "[property][dynamics][slow]") {
  const Scenario s = without_lung("healthy");
  const Model model = make_trunk(s).model;
  const Recoil usual = measure_recoil(model, s.parameters);
  const auto check = [&](const Model& m, const Parameters<double>& p) {
    const Recoil recoil = measure_recoil(m, p);
    CHECK(recoil.time_factor == Approx(usual.time_factor).epsilon(5e-3));
    CHECK(recoil.gain == Approx(usual.gain).epsilon(1e-3));
  };
  for (const double factor : {0.5, 3.0}) {
    Parameters<double> p = s.parameters;
    p.damping *= factor;
    check(model, p);
    p = s.parameters;
    p.elasticity /= factor;
    check(model, p);
    Model other = model;  // a lighter one has a shorter step
    for (double& mass : other.mass) mass /= factor;
    check(other, s.parameters);
  }
  // Static: the muscle holds what it holds in a long breath.
  Scenario held = s;
  held.parameters.muscle *= 0.5;
  held.activation = {.rise_s = 0.01, .fast_fall_s = 10.0, .fast_fall_level = 1.0};
  held.time = {1e-3, 3.0};
  const double volume = curve_of(make_trunk(held), held).delta_v.back();
  CHECK(volume * held.parameters.elasticity / held.parameters.muscle == Approx(usual.gain).epsilon(1e-3));
}

TEST_CASE("Elasticity, muscle, damping and mass times the same number give the same motion",
          "[property][dynamics]") {
  // What no volume can tell: only the pressures grow. Times a power of two, not even the rounding differs.
  for (const Start start : {Start::rest, Start::periodic}) {
    Scenario s = breathing("healthy", 1.5);
    s.time.start = start;
    const Trunk trunk = make_trunk(s);
    const BreathRun once = run_breath(trunk, s, 0);
    Trunk heavy = trunk;
    for (double& mass : heavy.model.mass) mass *= 4.0;
    for (double* number : {&s.parameters.elasticity, &s.parameters.muscle, &s.parameters.damping})
      *number *= 4.0;
    const BreathRun more = run_breath(heavy, s, 0);
    CHECK(once.delta_v.size() > 1000);
    CHECK(more.delta_v == once.delta_v);
    CHECK(more.above_relaxation == once.above_relaxation);
    CHECK(more.peak_pressure_Pa == 4.0 * once.peak_pressure_Pa);
  }
}

TEST_CASE("What cannot repeat is refused", "[unit][dynamics]") {
  Scenario s = breathing("healthy", 2.0);
  const auto refused = [&](const char* says) {
    CHECK_THROWS_WITH(
        [&] {
          const Trunk trunk = make_trunk(s);
          require_stable(s, trunk);
        }(),
        Contains(says));
  };
  s.abdominal_volume = PiecewiseLinear({{0.0, 1.0}, {1.0, 1.01}}, 1.0);
  refused("cannot repeat");
  s.abdominal_volume = PiecewiseLinear({{0.0, 1.0}, {1.0, 1.01}, {2.0, 1.0}}, 1.0);
  const BreathRun run = run_breath(make_trunk(s), s, 0);
  CHECK(run.ending.completed());
  CHECK(run.max_relative_volume_error < 1e-12);
  s.activation.period_s = 1.5;
  refused("whole periods");
  s.activation.period_s = 1.0;
  CHECK_NOTHROW(make_trunk(s));
  s = breathing("healthy", 2.0);
  s.loads = {{RegionLoad::Kind::displacement,
              "pelvis",
              {0, 0, 1},
              {0, 0, 1},
              PiecewiseLinear({{0.0, 0.0}, {1.0, 0.01}}),
              {"here", 7}}};
  refused("here:7");
  s = breathing("healthy", 2.0);
  s.parameters.damping = 0.0;
  refused("never forgets how it started");
  s.parameters = {10.0, 0.1, 20.0, 0.8};
  refused("s to forget how it started");
  s = breathing("healthy", 2.0);
  s.time.start = Start::rest;
  const Trunk unmeasured = make_trunk(s);
  s.time.start = Start::periodic;
  CHECK_THROWS_AS(curve_of(unmeasured, s), std::logic_error);
}

TEST_CASE("A step that is chosen for breathing that repeats keeps its bound", "[property][dynamics][slow]") {
  Scenario s = breathing("healthy", 3.0, 0.5);
  const Trunk trunk = make_trunk(s);
  const TimeStepChoice choice = auto_time_step(trunk.model, s.parameters, s.activation, s.time);
  CHECK(choice.grid.start == Start::periodic);
  CHECK(choice.grid.duration_s == 3.0);
  CHECK(choice.grid.dt_s > 2e-3);
  s.time = choice.grid;
  const std::vector<double> chosen = gains_of(curve_of(trunk, s));
  s.time = {choice.grid.dt_s / 16.0, 3.0, Damping::centred, Start::periodic};
  const std::vector<double> exact = gains_of(curve_of(trunk, s));
  double apart = 0.0;
  for (std::size_t n = 0; n < chosen.size(); ++n)
    apart = std::max(apart, std::abs(chosen[n] - exact[16 * n]));
  CHECK(apart < auto_time_step_tolerance * span_of(exact));
}
