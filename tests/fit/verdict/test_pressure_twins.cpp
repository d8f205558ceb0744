// Twins with a lung: recordings of volume and pressures that the simulator itself makes, with truths drawn
// from the priors of the fit. Does the fit find the forces, and do its intervals hold them?

#include "support/pressure_twin.hpp"

using namespace trunk;
using namespace trunk::test;

namespace {

std::vector<Recovered> pressure_study(bool pressures, int repeats) {
  std::vector<Recovered> all;
  for (const char* name : {"k_elasticity", "k_muscle", "lung_elastance_cmH2O_per_L",
                           "abdominal_elastance_cmH2O_per_L", "respiratory_elastance_cmH2O_per_L"})
    all.push_back({name});
  std::vector<ChannelKind> kinds;
  if (pressures) kinds = {ChannelKind::pleural, ChannelKind::gastric};
  for (int k = 0; k < repeats; ++k) {
    const std::uint64_t seed = first_twin_seed(3000) + static_cast<std::uint64_t>(k);
    Random random(seed);
    const PressureTwin twin(random);
    ScenarioFile file;
    file.scenario = quiet_twin();
    enter_all(FittedTwin(std::move(file), recorded(twin, kinds, random)), twin, seed, all);
  }
  for (const Recovered& r : all)
    WARN((pressures ? "volume and pressures: " : "volume: ")
         << r.name << " covered in " << r.covered << " of " << repeats << ", error "
         << 100.0 * median(r.error) << " %, half width " << 100.0 * median(r.half_width) << " %");
  return all;
}

/// Fits breaths of a trunk whose muscle rests, which a pressure in the airway drives, Pa over 3.5 s. The fit
/// knows that pressure, and no other.
void check_passive(const PiecewiseLinear& airway_Pa) {
  Scenario s = quiet_twin();
  s.time.duration_s = 3.5;
  s.time.dt_s = 2e-3;
  s.parameters.muscle = 0.0;
  s.pleura.airway_pressure = airway_Pa;
  const Trunk trunk = make_trunk(s);
  const VolumeCurve breath = simulate_volume(trunk, s.parameters, s.activation, s.time);
  REQUIRE(breath.ending.completed());
  Random random(71);
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
  ScenarioFile file;
  file.scenario = quiet_twin();
  const FittedTwin fitted(std::move(file), trace);
  const auto& [segmentation, fit, ledger, e, results] = fitted;
  CHECK(std::none_of(fit.screening().gates.begin(), fit.screening().gates.end(),
                     [](const Gate& gate) { return gate.name == "machine_driven"; }));
  const FitResult &muscle = *results.find("k_muscle"),
                  &respiratory = *results.find("respiratory_elastance_cmH2O_per_L");
  const double elastance = test::recoil_of(trunk, s.parameters).elastance * s.parameters.elasticity,
               truth = (elastance + s.parameters.lung_elastance) / cmH2O_per_L;
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

}  // namespace

TEST_CASE("Breaths of a ventilator need no muscle once the pressure of the airway is known",
          "[property][slow]") {
  const double top_Pa = 14.0 * Pa_per_cmH2O, peep_Pa = 5.0 * Pa_per_cmH2O;
  check_passive(PiecewiseLinear(
      {{0.0, peep_Pa}, {0.08, top_Pa}, {1.2, top_Pa}, {1.3, peep_Pa}, {3.5, peep_Pa}}, peep_Pa));
}

TEST_CASE("Passive volume control needs no muscle once the pressure of the airway is known",
          "[nightly][slow]") {
  // A constant flow of 0.4 L/s takes a step of R V' and then a ramp of E V, and a hold shows E V alone.
  const double peep_Pa = 5.0 * Pa_per_cmH2O, step_Pa = 1.5 * Pa_per_cmH2O, ramp_Pa = 7.0 * Pa_per_cmH2O;
  check_passive(PiecewiseLinear({{0.0, peep_Pa},
                                 {0.08, peep_Pa + step_Pa},
                                 {1.2, peep_Pa + step_Pa + ramp_Pa},
                                 {1.28, peep_Pa + ramp_Pa},
                                 {1.5, peep_Pa + ramp_Pa},
                                 {1.6, peep_Pa},
                                 {3.5, peep_Pa}},
                                peep_Pa));
}

TEST_CASE("Pressures beside the volume give the forces of a twin: a slice", "[property][slow]") {
  for (const Recovered& r : pressure_study(true, 2)) {
    INFO(r.name);
    CHECK(r.covered >= 1);
    if (r.name != "k_elasticity") CHECK(median(r.error) < 0.25);
  }
}

TEST_CASE("Pressures beside the volume give the forces of 100 twins", "[nightly][slow]") {
  const int repeats = twin_repeats(100);
  for (const Recovered& r : pressure_study(true, repeats)) {
    INFO(r.name);
    CHECK(r.covered >= 0.9 * repeats);
    if (r.name != "k_elasticity") CHECK(median(r.error) <= 0.1);
  }
}

TEST_CASE("Volume alone covers the stiffness of 100 twins with a lung", "[nightly][slow]") {
  const int repeats = twin_repeats(100);
  const std::vector<Recovered> all = pressure_study(false, repeats);
  CHECK(all.front().covered >= 0.9 * repeats);
}
