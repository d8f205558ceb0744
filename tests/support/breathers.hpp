#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "support/random.hpp"
#include "traces/trace.hpp"

namespace trunk::test {

/// A muscle's activation t after it begins: `ti` is the time of its peak (1), `period` that to the next
/// breath.
using MuscleShape = std::function<double(double t, double ti, double period)>;

struct NamedShape {
  std::string name;
  MuscleShape activation;
};

inline double parabola(double t, double ti) {
  return t / ti * (2 - t / ti);
}

/// Five ways in which inspiratory muscles may work. The last one is what Shee et al. 1985 measured.
inline std::vector<NamedShape> muscle_shapes() {
  const auto straight = [](double t, double ti, double period) {
    const double te = period - ti, s = (t - ti) / te;
    if (s < 0) return t / ti;
    return s < 0.25 ? 1 - 0.7 * s / 0.25 : std::max(0.3 * (0.9 - s) / 0.65, 0.0);
  };
  const auto parabolic = [](double t, double ti, double) {
    return t < ti ? parabola(t, ti) : std::exp(-(t - ti) / 0.25);
  };
  const auto half_sine = [](double t, double ti, double) {
    return t < 2 * ti ? std::sin(std::numbers::pi * t / (2 * ti)) : 0.0;
  };
  const auto quick = [](double t, double ti, double) { return t < ti ? t / ti : std::exp(-(t - ti) / 0.1); };
  const auto measured = [](double t, double ti, double period) {
    if (t < ti) return parabola(t, ti);
    const double s = (t - ti) / (period - ti);
    return s < 0.23 ? 1 - 0.5 * s / 0.23 : std::max(0.5 * (0.79 - s) / 0.56, 0.0);
  };
  return {{"straight lines", straight},
          {"parabola, falls in 0.25 s", parabolic},
          {"half sine", half_sine},
          {"falls in 0.1 s", quick},
          {"falls as measured", measured}};
}

/// A ventilator as a drive: airway pressure over elastance rises in rise_s, is held until ti and falls by a
/// valve.
inline MuscleShape pressure_control(double rise_s, double valve_s = 0.04) {
  return [=](double t, double ti, double) {
    if (t < ti) return rise_s > 0 ? std::min(t / rise_s, 1.0) : 1.0;
    return std::exp(-(t - ti) / valve_s);
  };
}

/// A subject with one resistance and one elastance, and breaths that vary. Volumes in m3, times in s.
struct Breather {
  MuscleShape activation;
  double recoil_s = 0.3;  ///< R/E
  double period_s = 3.3, inspired_part = 0.4;
  double drive_m3 = 600e-6;  ///< muscle pressure at its peak over elastance
  double size_cv = 0.1, timing_cv = 0.05;
  int breaths = 12;
  double rate_hz = 100;
  double noise_m3_s = 10e-6;  ///< white, on flow
};

/// A ventilator that imposes its flow: constant, or falling linearly to `last` of the first one; then a hold.
struct ImposedFlow {
  double recoil_s = 0.5, period_s = 4, inspired_part = 0.33, hold_part = 0;  // of the period
  double tidal_volume_m3 = 500e-6, last = 1, valve_s = 0.04;
  double size_cv = 0.01, timing_cv = 0.02;
  int breaths = 12;
  double rate_hz = 100, noise_m3_s = 10e-6;
};

inline Trace imposed(const ImposedFlow& vent, std::uint64_t seed) {
  constexpr double step = 2e-3;
  Random random(seed);
  Trace trace;
  trace.source = "ventilator.csv", trace.kind = SignalKind::flow, trace.value_unit = "L_s";
  double volume = 0, time = 0, next = 0;
  for (int b = 0; b < vent.breaths + 1; ++b) {
    const double size = vent.tidal_volume_m3 * (1 + vent.size_cv * random.normal());
    const double period = vent.period_s * (1 + vent.timing_cv * random.normal());
    const double ti = vent.inspired_part * vent.period_s, hold = vent.hold_part * vent.period_s;
    const double first = size / ti / (0.5 + 0.5 * vent.last);
    double full = 0;
    for (double t = 0; t < period; t += step, time += step) {
      double flow = 0;
      if (t < ti)
        flow = first * (1 - (1 - vent.last) * t / ti), full = volume;
      else if (t >= ti + hold)  // the pressure behind the valve falls within valve_s
        flow = (full * std::exp(-(t - ti - hold) / vent.valve_s) - volume) / vent.recoil_s;
      volume += step * flow;
      if (time < next - 1e-9) continue;
      trace.time_s.push_back(time);
      trace.value.push_back(flow + vent.noise_m3_s * random.normal());
      next += 1 / vent.rate_hz;
    }
  }
  return trace;
}

/// Returns the flow of a breather, state carried from breath to breath: tau V' + V = u, solved exactly for a
/// drive u that is linear between steps of 2 ms. Four breaths pass before the record begins.
inline Trace breathed(const Breather& who, std::uint64_t seed) {
  constexpr int before = 4;
  constexpr double step = 2e-3;
  Random random(seed);
  Trace trace;
  trace.source = "breather.csv", trace.kind = SignalKind::flow, trace.value_unit = "L_s";
  const double keep = std::exp(-step / who.recoil_s), tau = who.recoil_s;
  double volume = 0, drive = 0, time = 0, next = 0, tail = 0;  // tail: what the next activation cuts
  for (int b = 0; b < before + who.breaths + 1; ++b) {
    const double size = who.drive_m3 * std::max(1 + who.size_cv * random.normal(), 0.3);
    const double period = who.period_s * std::max(1 + who.timing_cv * random.normal(), 0.5);
    const double ti = who.inspired_part * who.period_s * std::max(1 + who.timing_cv * random.normal(), 0.5);
    const int steps = static_cast<int>(period / step);
    const double begin = drive;
    for (int k = 1; k <= steps; ++k) {
      const double t = k * step;
      // A muscle that has not let go fades within 50 ms as the next breath begins.
      tail = begin * std::max(1 - t / 0.05, 0.0);
      const double to = std::max(size * who.activation(t, ti, period), tail), slope = (to - drive) / step;
      const double rest = drive - tau * slope;  // the particular solution of a linear drive is rest + slope t
      const double after = rest + slope * step + (volume - rest) * keep;
      drive = to, volume = after;
      if (b < before) continue;
      if (time >= next - 1e-9) {
        trace.time_s.push_back(time);
        trace.value.push_back((drive - volume) / tau + who.noise_m3_s * random.normal());
        next += 1 / who.rate_hz;
      }
      time += step;
    }
  }
  return trace;
}

}  // namespace trunk::test
