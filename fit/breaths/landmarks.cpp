#include "breaths/landmarks.hpp"

#include <algorithm>
#include <cmath>

#include "breaths/robust.hpp"
#include "breaths/turn_fit.hpp"

namespace trunk {
namespace {

constexpr double around_turn = 0.1, around_in_noise = 0.35;  // of a height: what is fitted
constexpr double noise_share = 8;                            // so many deviations of the bins are added
constexpr double around_pause = 0.3;                         // of a height
constexpr double seen = 0.5;  // of what is fitted: below, the side of a turn is not in the record
constexpr int more_bins = 3;  // on either side
constexpr double better_shape = 0.1, least_misfit = 1e-8;
constexpr double longest_side = 3;       // breaths
constexpr double bins_per_breath = 200;  // fits are made to means over bins
constexpr std::size_t many_turns = 40;   // enough to tell the shape
constexpr double least_phase = 0.01;     // of a breath

using Samples = std::span<const double>;
using Indices = std::vector<std::size_t>;

/// The record in bins, and the bins of its turning points.
struct Bins {
  std::vector<double> time, volume;
  std::vector<double> smooth;  // volume, as far as noise asks for it: only to see how high it is
  Indices trough, peak;
  double period = 0;
  double noise = 0;   // deviation of `smooth`
  double around = 0;  // part of a height that is fitted
};

std::size_t bin_at(Samples begins, double time) {
  return static_cast<std::size_t>(std::upper_bound(begins.begin(), begins.end(), time) - begins.begin()) - 1;
}

Bins binned(Samples time, Samples volume, const WholeBreaths& breaths) {
  const Indices &trough = breaths.trough, &peak = breaths.peak;
  Bins bins;
  bins.period = (time[trough.back()] - time[trough.front()]) / static_cast<double>(peak.size());
  std::vector<double> begins;
  for (std::size_t i = 0; i < time.size();) {
    begins.push_back(time[i]);
    const double end = time[i] + bins.period / bins_per_breath;
    double t = 0, v = 0, count = 0;
    do t += time[i], v += volume[i], ++count, ++i;
    while (i < time.size() && time[i] < end);
    bins.time.push_back(t / count);
    bins.volume.push_back(v / count);
  }
  for (const std::size_t i : trough) bins.trough.push_back(bin_at(begins, time[i]));
  for (const std::size_t i : peak) bins.peak.push_back(bin_at(begins, time[i]));
  return bins;
}

// The samples around one turn; the volume rises away from it.
struct Window {
  Samples time, volume, smooth;
  TurnSides sides;
  double height;
};

// Where to look on either side of a turn: up to these bins and these heights above it.
struct Reach {
  std::size_t first, last;
  double height_before, height_after;
};

Window around(const Bins& bins, std::size_t turn, const Reach& reach, double share) {
  const auto height = [&](std::size_t i) { return bins.smooth[i] - bins.smooth[turn]; };
  const auto inside = [&](std::size_t i, double full) { return height(i) <= share * full; };
  const auto enough = [&](std::size_t i, double full) { return height(i) > around_in_noise * full; };
  std::size_t from = turn, until = turn;
  while (from > reach.first && inside(from - 1, reach.height_before)) --from;
  while (until < reach.last && inside(until + 1, reach.height_after)) ++until;
  for (int more = 0; more < more_bins && from > reach.first && !enough(from, reach.height_before); ++more)
    --from;
  for (int more = 0; more < more_bins && until < reach.last && !enough(until, reach.height_after); ++more)
    ++until;
  const auto part = [&](const std::vector<double>& all) {
    return Samples(all).subspan(from, until - from + 1);
  };
  return {
      part(bins.time),
      part(bins.volume),
      part(bins.smooth),
      {height(from) > seen * share * reach.height_before, height(until) > seen * share * reach.height_after},
      std::max(reach.height_before, reach.height_after)};
}

std::vector<Window> around_rests(const Bins& bins, double share) {
  std::vector<Window> windows;
  const std::size_t n = bins.peak.size();
  for (std::size_t i = 0; i <= n; ++i) {
    const auto height = [&](std::size_t k) {
      return bins.smooth[bins.peak[k]] - bins.smooth[bins.trough[i]];
    };
    windows.push_back(around(bins, bins.trough[i],
                             {i > 0 ? bins.peak[i - 1] : 0, i < n ? bins.peak[i] : bins.time.size() - 1,
                              height(i > 0 ? i - 1 : 0), height(i < n ? i : n - 1)},
                             share));
  }
  return windows;
}

void keep(Window& w, std::size_t first, std::size_t count) {
  w.time = w.time.subspan(first, count), w.volume = w.volume.subspan(first, count);
}

// Of what comes before the inspiration, about as much as is fitted of it: not the whole tail of an
// expiration.
void shorten(Window& w, double longest_s) {
  if (!w.sides.after) return keep(w, 0, bin_at(w.time, w.time.front() + longest_s) + 1);
  const double low = *std::min_element(w.volume.begin(), w.volume.end()), high = w.volume.back();
  std::size_t third = w.time.size() - 1;
  while (third > 0 && w.volume[third] > low + (high - low) / 3) --third;
  const double length = std::min(4 * (w.time.back() - w.time[third]), longest_s);
  std::size_t first = 0;
  while (first + 1 < third && w.time[first] < w.time.back() - length) ++first;
  keep(w, first, w.time.size() - first);
}

// Of the volume turned upside down.
std::vector<Window> around_tops(const Bins& bins) {
  std::vector<Window> windows;
  for (std::size_t i = 0; i < bins.peak.size(); ++i) {
    const auto depth = [&](std::size_t k) { return bins.smooth[bins.trough[k]] - bins.smooth[bins.peak[i]]; };
    windows.push_back(around(bins, bins.peak[i], {bins.trough[i], bins.trough[i + 1], depth(i), depth(i + 1)},
                             bins.around));
  }
  return windows;
}

// Mean log misfit, which no single odd breath decides.
double misfit_of(const std::vector<Window>& windows, TurnShape shape) {
  const std::size_t stride = windows.size() / many_turns + 1;
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < windows.size(); i += stride, ++count) {
    const Window& w = windows[i];
    const double misfit = fit_turn(w.time, w.volume, shape, w.sides).misfit;
    sum += std::log(std::max(misfit / (w.height * w.height), least_misfit));
  }
  return sum / count;
}

// Flows that grow and fade evenly, unless others fit clearly better.
TurnShape shape_of(const std::vector<Window>& windows) {
  TurnShape best{2, 2};
  double least = misfit_of(windows, best) - better_shape;
  for (const double before : turn_powers)
    for (const double after : turn_powers)
      if (const double misfit = misfit_of(windows, {before, after}); misfit < least)
        least = misfit, best = {before, after};
  return best;
}

std::vector<Turn> turns_in(const std::vector<Window>& windows) {
  const TurnShape shape = shape_of(windows);
  std::vector<Turn> turns;
  for (const Window& w : windows) turns.push_back(fit_turn(w.time, w.volume, shape, w.sides));
  return turns;
}

// The record in bins above a base line.
Bins above(Bins bins, const KnotLine& rest, const WholeBreaths& breaths) {
  for (std::size_t i = 0; i < bins.time.size(); ++i) bins.volume[i] -= rest(bins.time[i], breaths.drift);
  const double noise = noise_deviation(bins.volume);
  const std::size_t width = averaging_width(noise, 0.01 * breaths.height, 5);
  bins.smooth = moving_average(bins.volume, width);
  bins.noise = noise / std::sqrt(static_cast<double>(width));
  bins.around = std::min(around_turn + noise_share * noise / breaths.height, around_in_noise);
  return bins;
}

KnotLine through(Samples time, Samples volume, const Indices& troughs) {
  KnotLine line;
  for (const std::size_t i : troughs) {
    line.time.push_back(time[i]);
    line.value.push_back(volume[i]);
  }
  return line;
}

// Between the peaks on either side, so that both phases last.
double between_peaks(Samples time, const WholeBreaths& breaths, std::size_t rest, double t) {
  const double from = rest > 0 ? time[breaths.peak[rest - 1] + 1] : time.front();
  const double until = rest < breaths.peak.size() ? time[breaths.peak[rest] - 1] : time.back();
  return std::clamp(t, from, until);
}

}  // namespace

Landmarks landmarks(Samples time, Samples volume, const WholeBreaths& breaths) {
  const Bins record = binned(time, volume, breaths);
  // Turns need a level base line, and the base line needs turns: first through the minima, then through the
  // rests.
  Landmarks found{through(time, volume, breaths.trough), {}, {}, {}};
  for (const bool closely : {false, true, true}) {
    const KnotLine line = std::move(found.rest);
    found = {};
    const Bins level = above(record, line, breaths);
    auto windows = around_rests(level, closely ? level.around : around_in_noise);
    for (auto& w : windows) shorten(w, longest_side * level.period);
    for (const Turn& rest : turns_in(windows)) {
      const double onset = between_peaks(time, breaths, found.rest.time.size(), rest.end_s);
      found.rest.time.push_back(onset);
      found.rest.value.push_back(rest.level + line(onset, breaths.drift));
      found.rests_s.push_back(std::max(onset - rest.begin_s, 0.0));
    }
  }
  Bins depth = above(record, found.rest, breaths);
  for (auto* values : {&depth.volume, &depth.smooth})
    for (double& v : *values) v = -v;
  const auto windows = around_tops(depth);
  const auto tops = turns_in(windows);
  for (std::size_t i = 0; i < tops.size(); ++i) {
    const Turn& top = tops[i];
    const double onset = found.rest.time[i], end = found.rest.time[i + 1];
    const double least = least_phase * (end - onset);
    found.peak_s.push_back(std::clamp(0.5 * (top.begin_s + top.end_s), onset + least, end - least));
    const double highest = -*std::min_element(windows[i].smooth.begin(), windows[i].smooth.end());
    found.tidal_volume.push_back(std::max(-top.level, highest - 2 * depth.noise));
  }
  return found;
}

}  // namespace trunk
