// Fits of what laboratories record beside quiet breathing: a constant pressure in the airway, support by a
// ventilator, and breaths that differ. Truths are drawn from the priors of the fit.

#include <fmt/format.h>

#include "dynamics/kernel.hpp"
#include "support/pressure_twin.hpp"

using namespace trunk;
using namespace trunk::test;

namespace {

constexpr ChannelKind both_catheters[] = {ChannelKind::pleural, ChannelKind::gastric};

/// A recording, and the scenario that it is fitted with.
struct Recorded {
  Trace trace;
  ScenarioFile file;
};
ScenarioFile quiet_file() {
  ScenarioFile file;
  file.scenario = quiet_twin();
  return file;
}

/// CPAP of 8 cmH2O, as a number in the scenario.
Recorded with_constant_pressure(PressureTwin& twin, Random& random) {
  const double pressure_Pa = 8.0 * Pa_per_cmH2O;
  ScenarioFile file = quiet_file();
  file.scenario.pleura.airway_pressure = PiecewiseLinear({{0.0, pressure_Pa}}, pressure_Pa);
  twin.connect(file.scenario.pleura.airway_pressure);
  return {recorded(twin, {std::begin(both_catheters), std::end(both_catheters)}, random), std::move(file)};
}

/// Pressure support of 6 above 5 cmH2O while the muscle pulls, as a column of the recording.
Recorded with_support(PressureTwin& twin, Random& random) {
  const double low_Pa = 5.0 * Pa_per_cmH2O, high_Pa = 11.0 * Pa_per_cmH2O,
               period_s = twin.scenario.time.duration_s, end_s = twin.scenario.activation.rise_s;
  twin.connect(PiecewiseLinear(
      {{0.0, low_Pa}, {0.2, high_Pa}, {end_s, high_Pa}, {end_s + 0.2, low_Pa}, {period_s, low_Pa}}, low_Pa));
  return {recorded(twin, {ChannelKind::pleural, ChannelKind::gastric, ChannelKind::airway}, random),
          quiet_file()};
}

/// Breaths whose strength differs by 10 % and whose times by 5 %, each of which begins with what the one
/// before has left.
Recorded with_variation(PressureTwin& twin, Random& random) {
  constexpr int before = 3, breaths = 13, steps_a_sample = 10;
  constexpr double size_cv = 0.1, timing_cv = 0.05, dt_s = 2e-3;
  const Scenario& s = twin.scenario;
  State<double> state = rest_state<double>(twin.trunk.model);
  Workspace<double> workspace = make_workspace(twin.trunk.model, s.parameters, dt_s, s.time.damping);
  TwinRecorder recorder({std::begin(both_catheters), std::end(both_catheters)});
  long steps = 0;
  for (int b = 0; b < before + breaths; ++b) {
    const double stretch = std::max(1.0 + timing_cv * random.normal(), 0.5);
    Parameters<double> p = s.parameters;
    p.muscle *= std::max(1.0 + size_cv * random.normal(), 0.2);
    BreathActivation<double> a = s.activation;
    a.period_s = 0.0;
    for (double* time_s : {&a.rise_s, &a.fast_fall_s, &a.slow_fall_s}) *time_s *= stretch;
    for (double t = 0.0; t < s.time.duration_s * stretch; t += dt_s, ++steps) {
      state.time_s = 0.0;  // nothing depends on it
      const StepReport<double> report = kernel().step(twin.trunk.model, p, a(t), state, workspace);
      REQUIRE(report.ok);
      if (b < before || steps % steps_a_sample != 0) continue;
      recorder.add(static_cast<double>(steps) * dt_s, state.lung_gain,
                   {report.pleural_pressure_Pa, report.pressure_Pa}, random);
    }
  }
  return {std::move(recorder).trace(), quiet_file()};
}

struct Family {
  const char* name;
  Recorded (*record)(PressureTwin&, Random&);
};
constexpr Family families[] = {{"CPAP of 8 cmH2O", &with_constant_pressure},
                               {"support of 6 above 5 cmH2O", &with_support},
                               {"strength CV 10 %, times CV 5 %", &with_variation}};

std::vector<Recovered> study(const Family& family, int repeats) {
  std::vector<Recovered> all = {{"k_muscle"},
                                {"lung_elastance_cmH2O_per_L"},
                                {"abdominal_elastance_cmH2O_per_L"},
                                {"respiratory_elastance_cmH2O_per_L"}};
  for (int k = 0; k < repeats; ++k) {
    const std::uint64_t seed = first_twin_seed(5000) + static_cast<std::uint64_t>(k);
    Random random(seed);
    PressureTwin twin(random, 400e-6);
    Recorded recorded = family.record(twin, random);
    enter_all(FittedTwin(std::move(recorded.file), std::move(recorded.trace)), twin, seed, all);
  }
  return all;
}

std::string table_of(const Family& family, const std::vector<Recovered>& all) {
  std::string text =
      fmt::format("{:<36}{:>9}{:>14}{:>12}\n", family.name, "covered", "error %", "half width %");
  for (const Recovered& r : all)
    text += fmt::format("  {:<34}{:>5}/{:<3}{:>14.1f}{:>12.1f}\n", r.name, r.covered, r.repeats,
                        100.0 * median(r.error), 100.0 * median(r.half_width));
  return text;
}

}  // namespace

TEST_CASE("Fits of CPAP, of support and of breaths that differ hold the truth in 90 of 100 recordings",
          "[nightly][slow]") {
  const int repeats = twin_repeats(100);
  for (const Family& family : families) {
    const std::vector<Recovered> all = study(family, repeats);
    WARN(table_of(family, all));
    for (const Recovered& r : all) {
      INFO(family.name << ": " << r.name);
      CHECK(r.covered >= 0.9 * r.repeats);
    }
  }
}
