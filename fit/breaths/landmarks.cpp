#include "breaths/landmarks.hpp"

#include <algorithm>

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
    for (const Turn& turn : turns_in(around_onsets(level, nearness), TurnKind::onset, record.period)) {
      rest.time.push_back(between_peaks(time, breaths, rest.time.size(), turn.end_s));
      rest.value.push_back(turn.level + found.rest(rest.time.back(), breaths.drift));
    }
    found.rest = std::move(rest);
  }
  const BinnedVolume level = above_rest(1), depth = above_rest(-1);
  for (const Turn& turn : turns_in(around_pauses(level), TurnKind::other, record.period))
    found.rests_s.push_back(std::max(found.rest.time[found.rests_s.size()] - turn.begin_s, 0.0));

  const auto windows = around_tops(depth);
  const auto tops = turns_in(windows, TurnKind::other, record.period);
  for (std::size_t i = 0; i < tops.size(); ++i) {
    const double onset = found.rest.time[i], end = found.rest.time[i + 1],
                 least = least_phase * (end - onset);
    const double middle = 0.5 * (tops[i].begin_s + tops[i].end_s);
    found.peak_s.push_back(std::clamp(middle, onset + least, end - least));
    // The fit rounds a sharp top, and noise raises the highest sample.
    const double highest = -*std::min_element(windows[i].smooth.begin(), windows[i].smooth.end());
    found.tidal_volume.push_back(std::max(-tops[i].level, highest - 2 * depth.noise));
  }
  return found;
}

}  // namespace trunk
