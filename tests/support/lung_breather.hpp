#pragma once

#include <cmath>
#include <functional>
#include <numbers>

#include "math/units.hpp"
#include "support/random.hpp"
#include "traces/trace.hpp"

namespace trunk::test {

/// A subject with one lung elastance and one resistance, whose flow is half a sine in inspiration, half a
/// sine in expiration and then nothing: work, pressure-time product and swing are known in closed form.
/// Volumes in L, pressures in cmH2O, times in s.
struct LungBreather {
  double elastance = 5, resistance = 2.5, tidal_volume = 0.5;
  double inspiration = 1.6, expiration = 2.0, pause = 0.4;
  double gastric_swing = 4;  ///< Pga follows the volume
  double peep = 0;           ///< that the muscles overcome in the last 0.2 s of the pause
  int breaths = 8;
  double rate = 100;
  double heart = 0, heart_period = 0.83;  ///< amplitude of a sine in pleural pressure
  double drift = 0;                       ///< of the pressures, a second
  double noise = 0;                       ///< standard deviation of the pressures

  double period() const { return inspiration + expiration + pause; }
  double peak_flow() const { return std::numbers::pi * tidal_volume / (2 * inspiration); }
  double swing() const {
    const double elastic = 0.5 * elastance * tidal_volume;
    return elastic + std::hypot(elastic, resistance * peak_flow());
  }
  double elastic_work() const { return 0.5 * elastance * tidal_volume * tidal_volume; }  ///< cmH2O L
  double resistive_work(double phase) const {
    return resistance * std::numbers::pi * std::numbers::pi * tidal_volume * tidal_volume / (8 * phase);
  }
  double pressure_time_product() const {
    return 0.5 * elastance * tidal_volume * inspiration + resistance * tidal_volume + peep * inspiration;
  }
};

/// Returns flow, pleural and gastric pressure of `who`, from half a pause before the first breath on.
inline Trace recorded(const LungBreather& who, std::uint64_t seed = 1) {
  Random random(seed);
  Trace trace;
  trace.source = "lung.csv", trace.kind = SignalKind::flow, trace.value_unit = "L_s";
  trace.channels = {{ChannelKind::pleural, "poes", "cmH2O", {}}, {ChannelKind::gastric, "pga", "cmH2O", {}}};
  const double pi = std::numbers::pi, vt = who.tidal_volume;
  const auto samples = static_cast<int>(who.rate * (who.breaths * who.period() + 0.5 * who.pause));
  for (int i = 0; i <= samples; ++i) {
    const double time = i / who.rate, since = time - 0.5 * who.pause;
    double t = std::fmod(since + who.period(), who.period());
    double flow = 0, volume = 0, effort = 0;
    if (t < who.inspiration) {
      flow = who.peak_flow() * std::sin(pi * t / who.inspiration);
      volume = 0.5 * vt * (1 - std::cos(pi * t / who.inspiration));
      effort = who.peep;
    } else if ((t -= who.inspiration) < who.expiration) {
      flow = -0.5 * pi * vt / who.expiration * std::sin(pi * t / who.expiration);
      volume = 0.5 * vt * (1 + std::cos(pi * t / who.expiration));
      effort = who.peep * volume / vt;
    } else {
      effort = who.peep * std::max(1 - (who.pause - (t - who.expiration)) / 0.2, 0.0);
    }
    const double beat = who.heart * std::sin(2 * pi * time / who.heart_period);
    const double pleural = -5 - who.elastance * volume - who.resistance * flow - effort + beat;
    trace.time_s.push_back(time);
    trace.value.push_back(m3_per_litre * flow);
    trace.channels[0].value.push_back(Pa_per_cmH2O *
                                      (pleural + who.drift * time + who.noise * random.normal()));
    trace.channels[1].value.push_back(Pa_per_cmH2O * (8 + who.gastric_swing * volume / vt + who.drift * time +
                                                      who.noise * random.normal()));
  }
  return trace;
}

/// => the channel without its kind's other values: each sample becomes value(time, sample).
inline void change(TraceChannel& channel, const std::vector<double>& time,
                   const std::function<double(double, double)>& value) {
  for (std::size_t i = 0; i < time.size(); ++i) channel.value[i] = value(time[i], channel.value[i]);
}

}  // namespace trunk::test
