#include "breaths/landmarks.hpp"

#include <algorithm>
#include <cmath>

#include "breaths/robust.hpp"

namespace trunk {
namespace {

constexpr double onset_low = 0.02, onset_low_in_noise = 0.1;  // of a height
constexpr double plateau_depth = 0.01;                        // of the maximum
constexpr double noise_allowed = 0.005;                       // of a height

using Samples = std::span<const double>;

// Averaged as far as the noise asks for, at most over a fiftieth of a breath: landmarks must not move.
std::size_t width_for_landmarks(Samples volume, const WholeBreaths& breaths) {
  const std::size_t samples = breaths.trough.back() - breaths.trough.front();
  return averaging_width(noise_deviation(volume), noise_allowed * breaths.height,
                         samples / breaths.peak.size() / 50);
}

std::vector<double> above(Samples time, Samples volume, const KnotLine& rest, double drift) {
  std::vector<double> height(volume.size());
  for (std::size_t i = 0; i < volume.size(); ++i) height[i] = volume[i] - rest(time[i], drift);
  return height;
}

// The last time before sample `until` at which the signal was at `level`, not before sample `from`.
double last_crossing(Samples time, Samples signal, std::size_t from, std::size_t until, double level) {
  std::size_t i = until;
  while (i > from && signal[i] > level) --i;
  if (i == until || signal[i] > level) return time[i];
  return time[i] + (time[i + 1] - time[i]) * (level - signal[i]) / (signal[i + 1] - signal[i]);
}

double onset(Samples time, Samples signal, std::size_t trough, std::size_t until, double low_level) {
  if (signal[until] <= 4 * low_level) return time[trough];  // lost in the noise, or the end of the record
  const double high = last_crossing(time, signal, trough, until, 4 * low_level);
  const double low = last_crossing(time, signal, trough, until, low_level);
  return std::clamp(2 * low - high, time[trough], std::max(low, time[trough]));
}

// After the last whole breath: as far as the record shows of the next inspiration.
std::size_t highest_from(Samples signal, std::size_t from) {
  const auto top = std::max_element(signal.begin() + static_cast<std::ptrdiff_t>(from), signal.end());
  return static_cast<std::size_t>(top - signal.begin());
}

struct Peak {
  double time, height;
};

Peak peak_between(Samples time, Samples signal, std::size_t from, std::size_t until, double noise) {
  const auto sample = [&](std::size_t i) { return signal.begin() + static_cast<std::ptrdiff_t>(i); };
  const auto top = std::max_element(sample(from), sample(until) + 1);
  const double level = *top - std::max(plateau_depth * *top, 2 * noise);
  std::size_t first = static_cast<std::size_t>(top - signal.begin()), last = first;
  while (first > from && signal[first - 1] >= level) --first;
  while (last < until && signal[last + 1] >= level) ++last;
  return {0.5 * (time[first] + time[last]), *top};
}

KnotLine through(Samples time, Samples volume, std::vector<double> knots) {
  KnotLine line{std::move(knots), {}};
  for (const double t : line.time) line.value.push_back(interpolated(time, volume, t));
  return line;
}

std::vector<double> times_of(Samples time, const std::vector<std::size_t>& samples) {
  std::vector<double> times;
  for (const std::size_t i : samples) times.push_back(time[i]);
  return times;
}

}  // namespace

Landmarks landmarks(Samples time_s, Samples volume_m3, const WholeBreaths& breaths) {
  const std::size_t width = width_for_landmarks(volume_m3, breaths);
  const auto volume = moving_average(volume_m3, width);
  const double noise = noise_deviation(volume_m3) / std::sqrt(static_cast<double>(width));
  const auto& trough = breaths.trough;

  const double low_level =
      std::clamp(3 * noise, onset_low * breaths.height, onset_low_in_noise * breaths.height);

  // Onsets need a level base line, and the base line needs onsets: once through the minima, then through the
  // onsets.
  auto rests = times_of(time_s, trough);
  const auto rough = above(time_s, volume, through(time_s, volume, rests), breaths.drift);
  for (std::size_t i = 0; i < trough.size(); ++i) {
    const std::size_t until = i < breaths.peak.size() ? breaths.peak[i] : highest_from(rough, trough[i]);
    rests[i] = onset(time_s, rough, trough[i], until, low_level);
  }

  Landmarks found{through(time_s, volume, rests), {}, {}};
  const auto level = above(time_s, volume, found.rest, breaths.drift);
  for (std::size_t i = 0; i < breaths.peak.size(); ++i) {
    // Strictly inside the breath, so that both phases last.
    const auto from = std::upper_bound(time_s.begin(), time_s.end(), found.rest.time[i]) - time_s.begin();
    const Peak peak = peak_between(time_s, level, static_cast<std::size_t>(from), trough[i + 1] - 1, noise);
    found.peak_s.push_back(peak.time);
    found.tidal_volume_m3.push_back(peak.height);
  }
  return found;
}

}  // namespace trunk
