#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "breaths/segment.hpp"
#include "support/random.hpp"

namespace trunk::test {

/// Half cosines have a round top. A muscle and recoil have a sharp one: flow falls to zero, and within 60 ms
/// recoil blows out at its fastest.
enum class Waveform { cosines, recoil };

struct TrueBreath {
  double tidal_m3 = 500e-6, inspiration_s = 1.7, expiration_s = 2.3, pause_s = 0.5;
  double duration_s() const { return inspiration_s + expiration_s + pause_s; }
};

/// Breaths that are known, and how they are recorded.
struct TrueRecording {
  std::vector<TrueBreath> breaths;
  Waveform waveform = Waveform::recoil;
  bool as_flow = true;
  double rate_hz = 100, lead_s = 1.5, tail_s = 1.5;  ///< no breathing before and after
  double flow_noise = 0, mask_noise = 0;             ///< m3/s, white; the latter outside of breathing
  double heart_flow = 0, heart_volume = 0;           ///< amplitudes, m3/s and m3
  double heart_hz = 1.2;
  double wander_m3 = 0, wander_s = 0;  ///< amplitude and period of the base line
  std::uint64_t seed = 1;

  std::vector<double> onsets() const {
    std::vector<double> onsets{lead_s};
    for (const TrueBreath& b : breaths) onsets.push_back(onsets.back() + b.duration_s());
    return onsets;
  }
};

/// Returns breaths whose size and duration vary by 10 % (standard deviation).
inline std::vector<TrueBreath> varied_breaths(std::size_t count, TrueBreath usual, Random& random) {
  std::vector<TrueBreath> breaths;
  for (std::size_t i = 0; i < count; ++i) {
    const double size = std::max(1 + 0.1 * random.normal(), 0.6),
                 time = std::max(1 + 0.1 * random.normal(), 0.6);
    breaths.push_back(
        {size * usual.tidal_m3, time * usual.inspiration_s, time * usual.expiration_s, time * usual.pause_s});
  }
  return breaths;
}

/// The flow of a breath, t after its onset, up to its scale: of inspiration and of expiration.
inline double shape_of_flow(const TrueBreath& b, Waveform waveform, double t) {
  constexpr double pi = std::numbers::pi;
  if (t < 0 || t > b.inspiration_s + b.expiration_s) return 0;
  const bool in = t < b.inspiration_s;
  const double phase = in ? t / b.inspiration_s : (t - b.inspiration_s) / b.expiration_s;
  if (waveform == Waveform::cosines || in)
    return std::pow(std::sin(pi * phase), waveform == Waveform::cosines ? 1 : 0.8);
  const double s = t - b.inspiration_s, recoil_s = 0.18 * b.expiration_s;
  return (1 - std::exp(-s / 0.06)) * (std::exp(-s / recoil_s) - std::exp(-b.expiration_s / recoil_s));
}

/// Returns the volume of the breaths at the times (increasing): the flow, summed finely and scaled so that
/// each breath returns what it takes.
inline std::vector<double> true_volume(const TrueRecording& r, const std::vector<double>& times) {
  const std::vector<double> onsets = r.onsets();
  std::vector<double> volume(times.size(), 0.0);
  for (std::size_t k = 0; k < r.breaths.size(); ++k) {
    const TrueBreath& b = r.breaths[k];
    constexpr int fine = 1500;
    std::vector<double> sums;  // of each phase, at fine steps
    for (const bool in : {true, false}) {
      const double length = in ? b.inspiration_s : b.expiration_s, from = in ? 0 : b.inspiration_s;
      double sum = 0;
      std::vector<double> phase{0};
      for (int i = 0; i < fine; ++i)
        phase.push_back(sum += shape_of_flow(b, r.waveform, from + (i + 0.5) * length / fine * (1 - 1e-12)));
      for (const double s : phase) sums.push_back(b.tidal_m3 * (in ? s / sum : 1 - s / sum));
    }
    auto i =
        static_cast<std::size_t>(std::lower_bound(times.begin(), times.end(), onsets[k]) - times.begin());
    for (; i < times.size() && times[i] < onsets[k + 1]; ++i) {
      const double t = times[i] - onsets[k];
      const bool in = t < b.inspiration_s;
      const double at =
          fine * std::min(in ? t / b.inspiration_s : (t - b.inspiration_s) / b.expiration_s, 1.0);
      const auto step = std::min(static_cast<std::size_t>(at), static_cast<std::size_t>(fine - 1));
      const std::size_t first = step + (in ? 0 : fine + 1);
      volume[i] = sums[first] + (at - static_cast<double>(step)) * (sums[first + 1] - sums[first]);
    }
  }
  return volume;
}

/// Returns the trace that a device records. A flow is the mean over a sample, so that its sum is exact.
inline Trace recording_trace(const TrueRecording& r) {
  constexpr double pi = std::numbers::pi;
  Random random(r.seed);
  const double heart = 2 * pi * random.unit(), slow = 2 * pi * random.unit(),
               begin = random.unit() / r.rate_hz;
  const double until = r.onsets().back() + r.tail_s;
  std::vector<double> times, edges;
  for (int i = 0; begin + i / r.rate_hz <= until; ++i) {
    times.push_back(begin + i / r.rate_hz);
    edges.push_back(times.back() - 0.5 / r.rate_hz);
  }
  edges.push_back(times.back() + 0.5 / r.rate_hz);
  std::vector<double> volume = true_volume(r, r.as_flow ? edges : times);
  const double omega = 2 * pi * r.heart_hz, ripple = r.heart_volume + r.heart_flow / omega;
  for (std::size_t i = 0; i < volume.size(); ++i) {
    const double t = r.as_flow ? edges[i] : times[i];
    const double wander = r.wander_s > 0 ? r.wander_m3 * std::sin(2 * pi * t / r.wander_s + slow) : 0;
    volume[i] += wander + ripple * std::sin(omega * t + heart);
  }
  Trace trace;
  trace.source = "true.csv";
  trace.time_s = times;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const bool breathing = times[i] > r.lead_s && times[i] < r.onsets().back();
    const double noise = breathing || r.mask_noise == 0 ? r.flow_noise : r.mask_noise;
    trace.value.push_back(r.as_flow ? (volume[i + 1] - volume[i]) * r.rate_hz + noise * random.normal()
                                    : volume[i]);
  }
  trace.kind = r.as_flow ? SignalKind::flow : SignalKind::volume;
  trace.value_unit = r.as_flow ? "L_s" : "ml";
  return trace;
}

struct MeanAndDeviation {
  double count = 0, sum = 0, squares = 0;
  void add(double x) { ++count, sum += x, squares += x * x; }
  double mean() const { return sum / count; }
  double deviation() const { return std::sqrt(std::max(squares / count - mean() * mean(), 0.0)); }
};

/// What a segmentation made of breaths that are known.
struct BreathScore {
  std::vector<std::size_t> missing;    ///< true breaths from a tenth of the median tidal volume on
  std::size_t invented = 0;            ///< breaths that are none of the true ones
  std::size_t invented_kept = 0;       ///< those of them that are not rejected
  MeanAndDeviation onset_ms, peak_ms;  ///< late is positive
  MeanAndDeviation volume_percent;     ///< too large is positive

  void add(const TrueRecording& r, const Segmentation& s);
};

inline void BreathScore::add(const TrueRecording& r, const Segmentation& s) {
  const std::vector<double> onsets = r.onsets();
  std::vector<double> sizes;
  for (const TrueBreath& b : r.breaths) sizes.push_back(b.tidal_m3);
  std::sort(sizes.begin(), sizes.end());
  std::vector<bool> taken(s.breaths.size(), false);
  for (std::size_t k = 0; k < r.breaths.size(); ++k) {
    const TrueBreath& b = r.breaths[k];
    const double peak = onsets[k] + b.inspiration_s, near = 0.5 * b.duration_s();
    std::size_t best = s.breaths.size();
    for (std::size_t i = 0; i < s.breaths.size(); ++i)
      if (!taken[i] && std::abs(s.breaths[i].peak_s - peak) < near &&
          (best == s.breaths.size() ||
           std::abs(s.breaths[i].peak_s - peak) < std::abs(s.breaths[best].peak_s - peak)))
        best = i;
    if (best == s.breaths.size()) {
      if (b.tidal_m3 >= 0.1 * sizes[sizes.size() / 2]) missing.push_back(k);
      continue;
    }
    taken[best] = true;
    onset_ms.add(1e3 * (s.breaths[best].onset_s - onsets[k]));
    peak_ms.add(1e3 * (s.breaths[best].peak_s - peak));
    volume_percent.add(100 * (s.breaths[best].tidal_volume_m3 / b.tidal_m3 - 1));
  }
  for (std::size_t i = 0; i < taken.size(); ++i) {
    invented += taken[i] ? 0 : 1;
    invented_kept += taken[i] || !s.breaths[i].kept ? 0 : 1;
  }
}

}  // namespace trunk::test
