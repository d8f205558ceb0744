#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "breaths/segment.hpp"
#include "errors/input_error.hpp"

namespace trunk {

struct SyntheticShape {
  double tidal_volume_m3 = 500e-6, inspiration_s = 1.5, expiration_s = 2.0, pause_s = 0.5;
  bool ventilated = false;  // constant flow for two thirds of inspiration, held, then exponential expiration
  double duration() const { return inspiration_s + expiration_s + pause_s; }
  double top_s() const { return ventilated ? 5 * inspiration_s / 6 : inspiration_s; }
};

// Volume t after the onset of a breath: half a cosine up, half a cosine down, rest; or a ventilator's.
inline double volume_in(const SyntheticShape& breath, double t) {
  const double up = t / breath.inspiration_s, down = (t - breath.inspiration_s) / breath.expiration_s;
  if (breath.ventilated)
    return breath.tidal_volume_m3 * (up < 1 ? std::min(1.5 * up, 1.0) : std::exp(-6 * down));
  const double phase = up < 1 ? up : std::max(1 - down, 0.0);
  return breath.tidal_volume_m3 * 0.5 * (1 - std::cos(std::numbers::pi * phase));
}

struct Record {
  std::vector<SyntheticShape> breaths = std::vector<SyntheticShape>(6);
  double rate_hz = 100;
  double skip_s = 0;      // cut from the start, inside the first breath
  double cut_s = 0;       // cut from the end, inside the last breath
  double noise_m3 = 0;    // white, on volume
  double drift_m3_s = 0;  // leak
  unsigned seed = 5;
};

inline std::vector<double> onsets_of(const Record& record) {
  std::vector<double> onsets{-record.skip_s};
  for (const auto& breath : record.breaths) onsets.push_back(onsets.back() + breath.duration());
  return onsets;
}

inline Trace volume_trace(const Record& record) {
  Trace trace;
  trace.source = "made.csv";
  const auto onsets = onsets_of(record);
  std::mt19937 random(record.seed);
  std::normal_distribution<double> normal;
  std::size_t current = 0;
  for (int i = 0; i / record.rate_hz <= onsets.back() - record.cut_s + 1e-9; ++i) {
    const double t = i / record.rate_hz;
    while (current + 1 < record.breaths.size() && t >= onsets[current + 1]) ++current;
    trace.time_s.push_back(t);
    trace.value.push_back(volume_in(record.breaths[current], t - onsets[current]) + record.drift_m3_s * t +
                          record.noise_m3 * normal(random));
  }
  return trace;
}

inline Trace flow_trace(const Record& record, double offset_m3_s) {
  Trace trace = volume_trace(record);
  trace.kind = SignalKind::flow;
  trace.value_unit = "L_s";
  auto volume = trace.value;
  for (std::size_t i = 1; i + 1 < volume.size(); ++i)
    trace.value[i] = (volume[i + 1] - volume[i - 1]) * record.rate_hz / 2 + offset_m3_s;
  trace.value.front() = trace.value.back() = offset_m3_s;
  return trace;
}

// As ventilators show it: the volume starts from 0 at every onset.
inline Trace with_resets(Trace trace, const std::vector<double>& onsets) {
  double offset = 0;
  std::size_t next = 1;
  for (std::size_t i = 0; i < trace.value.size(); ++i) {
    if (next < onsets.size() && trace.time_s[i] >= onsets[next]) offset = trace.value[i], ++next;
    trace.value[i] -= offset;
  }
  return trace;
}

inline std::string error_of(const Trace& trace) {
  try {
    segment_breaths(trace);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace trunk
