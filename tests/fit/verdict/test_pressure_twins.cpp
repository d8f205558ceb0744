// Twins with a lung: recordings of volume and pressures that the simulator itself makes, with truths drawn
// from the priors of the fit. Does the fit find the forces, and do its intervals hold them?

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "breaths/segment.hpp"
#include "dynamics/recoil.hpp"
#include "estimation/start.hpp"
#include "gates/gates.hpp"
#include "math/median.hpp"
#include "math/units.hpp"
#include "subject/subject_fit.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"
#include "support/trunks.hpp"

using namespace trunk;

namespace {

constexpr double per_unit = m3_per_litre / Pa_per_cmH2O;

/// Quiet breathing of a trunk with a lung, before its truth is drawn.
Scenario quiet_twin() {
  Scenario s = test::breathing_air();
  s.time.start = Start::periodic;
  return s;
}

/// A subject whose numbers are drawn from the priors, and who breathes 500 ml.
struct PressureTwin {
  Scenario scenario = quiet_twin();
  Trunk trunk;
  VolumeCurve breath;
  double abdominal = 0.0, respiratory = 0.0;  // elastances, cmH2O/L

  explicit PressureTwin(test::Random& random) {
    Parameters<double>& p = scenario.parameters;
    p.damping *= std::pow(1.6, random.normal());
    p.abdomen_factor *= std::pow(1.6, random.normal());
    p.lung_elastance = 5.0 / per_unit * std::pow(1.5, random.normal());
    p.resistance = 2.5 / per_unit * std::pow(1.5, random.normal());
    trunk = make_trunk(scenario);
    Parameters<double> resting = p;
    resting.elasticity = 50.0 * p.damping;
    const Recoil recoil = measure_recoil(trunk.model, resting);
    abdominal = 7.0 * std::pow(1.4, random.normal());
    p.elasticity = abdominal / per_unit / recoil.abdominal;
    respiratory = per_unit * (recoil.elastance * p.elasticity + p.lung_elastance);
    p.muscle = 0.01 * p.elasticity;
    scenario.time.dt_s = 2e-3;
    for (int k = 0; k < 3; ++k) {
      breath = simulate_volume(trunk, p, scenario.activation, scenario.time);
      REQUIRE(breath.ending.completed());
      p.muscle *= 500e-6 / *std::max_element(breath.delta_v.begin(), breath.delta_v.end());
    }
    breath = simulate_volume(trunk, p, scenario.activation, scenario.time);
  }
};

/// Twelve breaths at 50 Hz, with white noise of 1 % of the tidal volume and of 0.3 cmH2O.
Trace pressures_recorded(const PressureTwin& twin, bool pressures, test::Random& random) {
  constexpr int breaths = 13;
  constexpr double rate_hz = 50.0, noise_m3 = 5e-6, noise_Pa = 0.3 * Pa_per_cmH2O;
  const double period_s = twin.scenario.time.duration_s, dt_s = twin.scenario.time.dt_s;
  Trace trace;
  trace.source = "twin.csv";
  trace.kind = SignalKind::volume;
  trace.value_unit = "m3";
  for (const ChannelKind kind : {ChannelKind::pleural, ChannelKind::gastric})
    if (pressures) trace.channels.push_back({kind, kind == ChannelKind::pleural ? "poes" : "pga", "Pa", {}});
  for (double t = 0.0; t < breaths * period_s; t += 1.0 / rate_hz) {
    const std::vector<double> at = {std::fmod(t, period_s)};
    const auto value = [&](const std::vector<double>& curve) { return sampled(curve, dt_s, at)[0]; };
    trace.time_s.push_back(t);
    trace.value.push_back(value(twin.breath.delta_v) + noise_m3 * random.normal());
    for (TraceChannel& channel : trace.channels)
      channel.value.push_back(
          value(channel.kind == ChannelKind::pleural ? twin.breath.pleural_Pa : twin.breath.abdominal_Pa) +
          noise_Pa * random.normal());
  }
  return trace;
}

struct Recovered {
  std::string name;
  int covered = 0;
  std::vector<double> error, half_width;  // relative
};

std::uint64_t first_pressure_seed() {
  const char* asked = std::getenv("TRUNK_TWINS_SEED");
  return asked != nullptr ? std::strtoull(asked, nullptr, 10) : 3000u;
}

/// Fits one recording, and enters how near its truth is.
void fit_pressure_twin(bool pressures, std::uint64_t seed, std::vector<Recovered>& all) {
  test::Random random(seed);
  const PressureTwin twin(random);
  const Segmentation segmentation = segment_breaths(pressures_recorded(twin, pressures, random));
  ScenarioFile file;
  file.scenario = quiet_twin();
  FitPlan plan;
  plan.estimation.profiles = false;
  plan.estimation.surface_points = 0;
  plan.estimation.execution.threads = 1;
  const SubjectFit fit(file, {mean_breath(segmentation), 0.0, trace_signs(segmentation)}, plan);
  Ledger ledger;
  const Estimation e = fit.carry_out(ledger);
  const FitResults results = fit.results(e);
  const Parameters<double>& p = twin.scenario.parameters;
  const double truth[] = {p.elasticity, p.muscle, per_unit * p.lung_elastance, twin.abdominal,
                          twin.respiratory};
  std::string line;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const FitResult* r = results.find(all[k].name);
    REQUIRE(r != nullptr);
    all[k].covered += r->lower95 <= truth[k] && truth[k] <= r->upper95;
    all[k].error.push_back(std::abs(r->value / truth[k] - 1.0));
    all[k].half_width.push_back(std::sqrt(r->upper95 / r->lower95) - 1.0);
    line += r->name + " " + std::to_string(r->value / truth[k]) + " [" +
            std::to_string(r->lower95 / truth[k]) + ", " + std::to_string(r->upper95 / truth[k]) + "]; ";
  }
  UNSCOPED_INFO(seed << ": " << line << e.simulations << " simulations, " << name_of(results.grade));
  if (std::getenv("TRUNK_TWINS_EACH") != nullptr)
    WARN(seed << ": " << line << e.simulations << " " << name_of(results.grade));
}

std::vector<Recovered> pressure_study(bool pressures, int repeats) {
  std::vector<Recovered> all;
  for (const char* name : {"k_elasticity", "k_muscle", "lung_elastance_cmH2O_per_L",
                           "abdominal_elastance_cmH2O_per_L", "respiratory_elastance_cmH2O_per_L"})
    all.push_back({name, 0, {}, {}});
  for (int k = 0; k < repeats; ++k)
    fit_pressure_twin(pressures, first_pressure_seed() + static_cast<std::uint64_t>(k), all);
  for (const Recovered& r : all)
    WARN((pressures ? "volume and pressures: " : "volume: ")
         << r.name << " covered in " << r.covered << " of " << repeats << ", error "
         << 100.0 * median(r.error) << " %, half width " << 100.0 * median(r.half_width) << " %");
  return all;
}

int pressure_repeats() {
  const char* asked = std::getenv("TRUNK_TWINS");
  return asked != nullptr ? std::atoi(asked) : 100;
}

}  // namespace

TEST_CASE("Breaths of a ventilator need no muscle once the pressure of the airway is known",
          "[property][slow]") {
  Scenario s = quiet_twin();
  s.time.duration_s = 3.5;
  s.time.dt_s = 2e-3;
  s.parameters.muscle = 0.0;
  const double top_Pa = 14.0 * Pa_per_cmH2O, peep_Pa = 5.0 * Pa_per_cmH2O;
  s.pleura.airway_pressure = PiecewiseLinear(
      {{0.0, peep_Pa}, {0.08, top_Pa}, {1.2, top_Pa}, {1.3, peep_Pa}, {3.5, peep_Pa}}, peep_Pa);
  const Trunk trunk = make_trunk(s);
  const VolumeCurve breath = simulate_volume(trunk, s.parameters, s.activation, s.time);
  REQUIRE(breath.ending.completed());
  test::Random random(71);
  Trace trace;
  trace.source = "ventilator.csv";
  trace.value_unit = "m3";
  trace.channels = {{ChannelKind::airway, "paw", "Pa", {}}};
  for (double t = 0.0; t < 13 * s.time.duration_s; t += 0.02) {
    const double at_s = std::fmod(t, s.time.duration_s);
    trace.time_s.push_back(t);
    trace.value.push_back(sampled(breath.delta_v, s.time.dt_s, {at_s})[0] + 3e-6 * random.normal());
    trace.channels[0].value.push_back(s.pleura.airway_pressure(at_s) + 10.0 * random.normal());
  }
  const Segmentation segmentation = segment_breaths(trace);
  ScenarioFile file;
  file.scenario = quiet_twin();
  FitPlan plan;
  plan.estimation.profiles = false;
  plan.estimation.surface_points = 0;
  plan.estimation.execution.threads = 1;
  const SubjectFit fit(file, {mean_breath(segmentation), 0.0, trace_signs(segmentation)}, plan);
  CHECK(std::none_of(fit.screening().gates.begin(), fit.screening().gates.end(),
                     [](const Gate& gate) { return gate.name == "machine_driven"; }));
  Ledger ledger;
  const Estimation e = fit.carry_out(ledger);
  const FitResults results = fit.results(e);
  const FitResult &muscle = *results.find("k_muscle"),
                  &respiratory = *results.find("respiratory_elastance_cmH2O_per_L");
  Parameters<double> resting = s.parameters;
  resting.elasticity = 50.0 * resting.damping;
  const Recoil recoil = measure_recoil(trunk.model, resting);
  const double truth = per_unit * (recoil.elastance * s.parameters.elasticity + s.parameters.lung_elastance);
  CAPTURE(muscle.value, muscle.lower95, muscle.upper95, respiratory.value, respiratory.lower95,
          respiratory.upper95, truth, e.quality.nrmse, e.simulations, e.search.stop_reason);
  const FitResult& above = *results.find("end_expiratory_above_relaxation_ml");
  CHECK(above.value == Approx(ml_per_m3 * breath.above_relaxation).epsilon(0.15));  // that the PEEP holds
  CHECK(e.cross_check->agree);
  CHECK(muscle.lower95 == 0.0);
  CHECK(muscle.upper95 < 0.3 * 19.2);  // of what a quiet breath takes
  CHECK(respiratory.lower95 <= truth);
  CHECK(truth <= respiratory.upper95);
  CHECK(respiratory.value == Approx(truth).epsilon(0.1));
}

TEST_CASE("Pressures beside the volume give the forces of a twin: a slice", "[property][slow]") {
  for (const Recovered& r : pressure_study(true, 2)) {
    INFO(r.name);
    CHECK(r.covered >= 1);
    if (r.name != "k_elasticity") CHECK(median(r.error) < 0.25);
  }
}

TEST_CASE("Pressures beside the volume give the forces of 100 twins", "[nightly][slow]") {
  const int repeats = pressure_repeats();
  for (const Recovered& r : pressure_study(true, repeats)) {
    INFO(r.name);
    CHECK(r.covered >= 0.9 * repeats);
    if (r.name != "k_elasticity") CHECK(median(r.error) <= 0.1);
  }
}

TEST_CASE("Volume alone covers the stiffness of 100 twins with a lung", "[nightly][slow]") {
  const int repeats = pressure_repeats();
  const std::vector<Recovered> all = pressure_study(false, repeats);
  CHECK(all.front().covered >= 0.9 * repeats);
}
