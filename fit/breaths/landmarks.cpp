#include "breaths/landmarks.hpp"

#include <algorithm>

#include "breaths/aligned_onsets.hpp"
#include "breaths/robust.hpp"
#include "breaths/turn_windows.hpp"

namespace trunk {
namespace {

constexpr double least_phase = 0.01;  // of a breath

using Samples = std::span<const double>;

KnotLine through(Samples time, Samples volume, const std::vector<std::size_t>& troughs) {
  KnotLine line;
  for (const std::size_t i : troughs) {
    line.time.push_back(time[i]);
    line.value.push_back(volume[i]);
  }
  return line;
}

// Returns t, limited to the time between the peaks on either side, so that both phases have a duration.
double between_peaks(Samples time, const WholeBreaths& breaths, std::size_t rest, double t) {
  const double from = rest > 0 ? time[breaths.peak[rest - 1] + 1] : time.front();
  const double until = rest < breaths.peak.size() ? time[breaths.peak[rest] - 1] : time.back();
  return std::clamp(t, from, until);
}

// Moves onsets to where a mean inspiration fits best. => found.rest
void align(Samples time, const BinnedVolume& level, const WholeBreaths& breaths, Landmarks& found) {
  std::vector<RoughBreath> rough;
  for (std::size_t i = 0; i < found.peak_s.size(); ++i)
    rough.push_back({found.rest.time[i], found.peak_s[i], found.tidal_volume[i]});
  const auto onsets = aligned_onsets(level, rough);
  for (std::size_t i = 0; i < onsets.size(); ++i) {
    const double onset = between_peaks(time, breaths, i, onsets[i]);
    found.rest.value[i] += breaths.drift * (onset - found.rest.time[i]);
    found.rest.time[i] = onset;
  }
}

}  // namespace

Landmarks landmarks(Samples time, Samples volume, const WholeBreaths& breaths) {
  const BinnedVolume record(time, volume, breaths);
  // Turns need a level base line, and the base line needs turns: so it goes first through the minima, then
  // through the rests.
  Landmarks found{through(time, volume, breaths.trough), {}, {}, {}};
  const auto above_rest = [&](double sign) {
    return record.above(found.rest, breaths.drift, breaths.height, sign);
  };
  for (const Nearness nearness : {Nearness::wide, Nearness::close, Nearness::close}) {
    const BinnedVolume level = above_rest(1);
    KnotLine rest;
    for (const Turn& turn :
         turns_in(around_onsets(level, nearness), TurnKind::onset, record.period, level.kind)) {
      rest.time.push_back(between_peaks(time, breaths, rest.time.size(), turn.end_s));
      rest.value.push_back(turn.level + found.rest(rest.time.back(), breaths.drift));
    }
    found.rest = std::move(rest);
  }
  const BinnedVolume level = above_rest(1), depth = above_rest(-1);
  for (const Turn& turn : turns_in(around_pauses(level), TurnKind::other, record.period, level.kind))
    found.rests_s.push_back(std::max(found.rest.time[found.rests_s.size()] - turn.begin_s, 0.0));

  const auto windows = around_tops(depth);
  std::vector<double> samples;
  for (std::size_t k = 0; k < time.size(); ++k)
    samples.push_back(found.rest(time[k], breaths.drift) - volume[k]);
  auto tops = turns_in(windows, TurnKind::other, record.period, depth.kind);
  const bool close = depth.closely < depth.around;
  std::vector<TurnWindow> close_windows;
  if (close) {
    close_windows = closely_around_tops(time, samples, depth, tops, windows);
    tops = turns_in(close_windows, TurnKind::other, record.period, depth.kind);
  }
  const double noise = close ? 3 * noise_deviation(samples) + depth.walk : 2 * depth.noise;
  for (std::size_t i = 0; i < tops.size(); ++i) {
    const double onset = found.rest.time[i], end = found.rest.time[i + 1],
                 least = least_phase * (end - onset);
    const double middle = 0.5 * (tops[i].begin_s + tops[i].end_s);
    found.peak_s.push_back(std::clamp(middle, onset + least, end - least));
    // The fit rounds a sharp top, or goes beyond the samples; and noise raises the highest sample.
    const Samples near = close ? close_windows[i].volume : windows[i].smooth;
    const double highest = -*std::min_element(near.begin(), near.end());
    const double top = std::max(-tops[i].level, highest - noise);
    found.tidal_volume.push_back(close ? std::min(top, highest + noise) : top);
  }
  if (level.kind == NoiseKind::walk) align(time, level, breaths, found);
  return found;
}

}  // namespace trunk
