#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "anatomy/breath_run.hpp"
#include "dynamics/recoil.hpp"
#include "math/median.hpp"
#include "math/units.hpp"
#include "problem/measured_curve.hpp"
#include "support/catch.hpp"
#include "support/fitted_twin.hpp"
#include "support/random.hpp"
#include "support/trunks.hpp"

namespace trunk::test {

inline constexpr double cmH2O_per_L = Pa_per_cmH2O / m3_per_litre;

/// Quiet breathing of a trunk with a lung, before its truth is drawn.
inline Scenario quiet_twin() {
  Scenario s = breathing_air();
  s.time.start = Start::periodic;
  return s;
}

/// Returns how a trunk springs back, at a stiffness at which inertia counts little.
inline Recoil recoil_of(const Trunk& trunk, Parameters<double> p) {
  p.elasticity = 50.0 * p.damping;
  return measure_recoil(trunk.model, p);
}

/// A subject whose numbers are drawn from the priors of a fit, and whose muscle breathes `tidal_volume_m3`.
struct PressureTwin {
  Scenario scenario = quiet_twin();
  Trunk trunk;
  VolumeCurve breath;
  double abdominal = 0.0, respiratory = 0.0;  // elastances, cmH2O/L

  explicit PressureTwin(Random& random, double tidal_volume_m3 = 500e-6) {
    Parameters<double>& p = scenario.parameters;
    p.damping *= std::pow(1.6, random.normal());
    p.abdomen_factor *= std::pow(1.6, random.normal());
    p.lung_elastance = 5.0 * cmH2O_per_L * std::pow(1.5, random.normal());
    p.resistance = 2.5 * cmH2O_per_L * std::pow(1.5, random.normal());
    trunk = make_trunk(scenario);
    const Recoil recoil = recoil_of(trunk, p);
    abdominal = 7.0 * std::pow(1.4, random.normal());
    p.elasticity = abdominal * cmH2O_per_L / recoil.abdominal;
    respiratory = (recoil.elastance * p.elasticity + p.lung_elastance) / cmH2O_per_L;
    p.muscle = 0.01 * p.elasticity;
    scenario.time.dt_s = 2e-3;
    for (int k = 0; k < 3; ++k) {
      breathe();
      p.muscle *= tidal_volume_m3 / *std::max_element(breath.delta_v.begin(), breath.delta_v.end());
    }
    breathe();
  }

  /// Lets the airway have a pressure, Pa, over a breath.
  void connect(const PiecewiseLinear& airway_Pa) {
    scenario.pleura.airway_pressure = airway_Pa;
    trunk = make_trunk(scenario);
    breathe();
  }

  /// Returns the truth of a result, by its name.
  double truth(const std::string& name) const {
    const Parameters<double>& p = scenario.parameters;
    if (name == "k_elasticity") return p.elasticity;
    if (name == "k_muscle") return p.muscle;
    if (name == "lung_elastance_cmH2O_per_L") return p.lung_elastance / cmH2O_per_L;
    return name == "abdominal_elastance_cmH2O_per_L" ? abdominal : respiratory;
  }

 private:
  void breathe() {
    breath = simulate_volume(trunk, scenario.parameters, scenario.activation, scenario.time);
    REQUIRE(breath.ending.completed());
  }
};

/// Makes a recording of a twin, with white noise of 5 ml (1 % of a tidal volume) and of 0.3 cmH2O.
class TwinRecorder {
 public:
  explicit TwinRecorder(std::vector<ChannelKind> kinds) {
    trace_.source = "twin.csv";
    trace_.kind = SignalKind::volume;
    trace_.value_unit = "m3";
    for (const ChannelKind kind : kinds)
      trace_.channels.push_back({kind, std::string(option_of(kind)), "Pa", {}});
  }

  /// Adds a sample, m3 and Pa; `pressures` are in the order of the channels.
  void add(double time_s, double volume, const std::vector<double>& pressures, Random& random) {
    constexpr double noise_m3 = 5e-6, noise_Pa = 0.3 * Pa_per_cmH2O;
    trace_.time_s.push_back(time_s);
    trace_.value.push_back(volume + noise_m3 * random.normal());
    for (std::size_t k = 0; k < pressures.size(); ++k)
      trace_.channels[k].value.push_back(pressures[k] + noise_Pa * random.normal());
  }

  Trace trace() && { return std::move(trace_); }

 private:
  Trace trace_;
};

/// Twelve equal breaths of a twin at 50 Hz, with the pressures of these kinds.
inline Trace recorded(const PressureTwin& twin, const std::vector<ChannelKind>& kinds, Random& random) {
  constexpr int breaths = 13;
  constexpr double rate_hz = 50.0;
  const double period_s = twin.scenario.time.duration_s, dt_s = twin.scenario.time.dt_s;
  TwinRecorder recorder(kinds);
  for (double t = 0.0; t < breaths * period_s; t += 1.0 / rate_hz) {
    const double at_s = std::fmod(t, period_s);
    const auto value = [&](const std::vector<double>& curve) { return sampled(curve, dt_s, {at_s})[0]; };
    std::vector<double> pressures;
    for (const ChannelKind kind : kinds)
      pressures.push_back(kind == ChannelKind::pleural   ? value(twin.breath.pleural_Pa)
                          : kind == ChannelKind::gastric ? value(twin.breath.abdominal_Pa)
                                                         : twin.scenario.pleura.airway_pressure(at_s));
    recorder.add(t, value(twin.breath.delta_v), pressures, random);
  }
  return std::move(recorder).trace();
}

/// How near the results of fits are to the truth.
struct Recovered {
  std::string name;
  int covered = 0, repeats = 0;
  std::vector<double> error{}, half_width{};  // relative

  void enter(const FitResult& r, double truth) {
    ++repeats;
    covered += r.lower95 <= truth && truth <= r.upper95;
    error.push_back(std::abs(r.value / truth - 1.0));
    half_width.push_back(0.5 * (r.upper95 - r.lower95) / r.value);
  }
};

/// Enters the results of one fit, and tells them if the test fails.
inline void enter_all(const FittedTwin& fitted, const PressureTwin& twin, std::uint64_t seed,
                      std::vector<Recovered>& all) {
  std::string line;
  for (Recovered& one : all) {
    const FitResult* r = fitted.results.find(one.name);
    REQUIRE(r != nullptr);
    const double truth = twin.truth(one.name);
    one.enter(*r, truth);
    line += r->name + " " + std::to_string(r->value / truth) + " [" + std::to_string(r->lower95 / truth) +
            ", " + std::to_string(r->upper95 / truth) + "]; ";
  }
  line = std::to_string(seed) + ": " + line + std::to_string(fitted.estimation.simulations) +
         " simulations, " + std::string(name_of(fitted.results.grade));
  UNSCOPED_INFO(line);
  if (std::getenv("TRUNK_TWINS_EACH") != nullptr) WARN(line);
}

/// Returns the seed of the first twin, and how many a study has: TRUNK_TWINS_SEED and TRUNK_TWINS change
/// them.
inline std::uint64_t first_twin_seed(std::uint64_t usual) {
  const char* asked = std::getenv("TRUNK_TWINS_SEED");
  return asked != nullptr ? std::strtoull(asked, nullptr, 10) : usual;
}
inline int twin_repeats(int usual) {
  const char* asked = std::getenv("TRUNK_TWINS");
  return asked != nullptr ? std::atoi(asked) : usual;
}

}  // namespace trunk::test
