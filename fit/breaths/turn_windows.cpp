#include "breaths/turn_windows.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "math/median.hpp"

namespace trunk {
namespace {

constexpr double seen = 0.5;        // part of the fitted height that a side of the turn must show
constexpr double longest_side = 3;  // breaths
constexpr int more_bins = 3;        // on either side, for sharp turns and few samples
constexpr std::size_t more_samples = 1;
constexpr std::size_t many_turns = 40;
constexpr double least_misfit = 1e-8;

constexpr double evenly = HUGE_VAL;                                          // a time constant
constexpr std::array onset_lags{0.0, 0.01, 0.02, 0.04, 0.08, 0.16, evenly};  // breaths
constexpr std::array other_lags{0.0, evenly};

using Samples = std::span<const double>;

// The limits of a window on either side of a turn: bins, and heights above the turn.
struct Reach {
  std::size_t first, last;
  double height_before, height_after;
};

TurnWindow around(const BinnedVolume& bins, std::size_t turn, const Reach& reach, double share) {
  const auto height = [&](std::size_t i) { return bins.smooth[i] - bins.smooth[turn]; };
  const auto inside = [&](std::size_t i, double full) { return height(i) <= share * full; };
  const auto enough = [&](std::size_t i, double full) { return height(i) > around_at_most * full; };
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

// A record may begin and end with much that is no breathing. Its first and last rest are seen within one and
// a half usual breaths from a peak (our choice).
constexpr double breaths_seen = 1.5;
std::size_t first_seen(const BinnedVolume& bins) {
  std::size_t first = bins.trough.front();
  while (first > 0 && bins.time[first - 1] >= bins.time[bins.peak.front()] - breaths_seen * bins.period)
    --first;
  return first;
}

std::size_t last_seen(const BinnedVolume& bins) {
  std::size_t last = bins.trough.back();
  while (last + 1 < bins.time.size() &&
         bins.time[last + 1] <= bins.time[bins.peak.back()] + breaths_seen * bins.period)
    ++last;
  return last;
}

std::vector<TurnWindow> around_rests(const BinnedVolume& bins, double share) {
  std::vector<TurnWindow> windows;
  const std::size_t n = bins.peak.size();
  for (std::size_t i = 0; i <= n; ++i) {
    const auto height = [&](std::size_t k) {
      return bins.smooth[bins.peak[k]] - bins.smooth[bins.trough[i]];
    };
    windows.push_back(
        around(bins, bins.trough[i],
               {i > 0 ? bins.peak[i - 1] : first_seen(bins), i < n ? bins.peak[i] : last_seen(bins),
                height(i > 0 ? i - 1 : 0), height(i < n ? i : n - 1)},
               share));
  }
  return windows;
}

void keep(TurnWindow& w, std::size_t first, std::size_t count) {
  w.time = w.time.subspan(first, count), w.volume = w.volume.subspan(first, count);
}

// Shortens what comes before the inspiration to about the length of the inspiration in the window, so that
// the long tail of an expiration does not dominate the fit.
void shorten(TurnWindow& w, double longest_s) {
  if (!w.sides.after) return keep(w, 0, bin_at(w.time, w.time.front() + longest_s) + 1);
  const double low = *std::min_element(w.volume.begin(), w.volume.end()), high = w.volume.back();
  std::size_t third = w.time.size() - 1;
  while (third > 0 && w.volume[third] > low + (high - low) / 3) --third;
  const double length = std::min(3 * (w.time.back() - w.time[third]), longest_s);
  std::size_t first = 0;
  while (first + 1 < third && w.time[first] < w.time.back() - length) ++first;
  keep(w, first, w.time.size() - first);
}

// Returns the mean log misfit, which one odd breath cannot dominate.
double misfit_of(const std::vector<TurnWindow>& windows, TurnShape shape, NoiseKind noise) {
  const std::size_t stride = windows.size() / many_turns + 1;
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < windows.size(); i += stride, ++count) {
    const TurnWindow& w = windows[i];
    const double misfit = fit_turn(w.time, w.volume, shape, w.sides, noise).misfit;
    sum += std::log(std::max(misfit / (w.height * w.height), least_misfit));
  }
  return sum / count;
}

TurnShape shape_of(const std::vector<TurnWindow>& windows, Samples lags_after, NoiseKind noise) {
  TurnShape best{evenly, evenly};
  double least = HUGE_VAL;
  for (const double before : other_lags)
    for (const double after : lags_after)
      if (const double misfit = misfit_of(windows, {before, after}, noise); misfit < least)
        least = misfit, best = {before, after};
  return best;
}

}  // namespace

std::vector<TurnWindow> around_onsets(const BinnedVolume& level, Nearness nearness) {
  auto windows = around_rests(level, nearness == Nearness::close ? level.around : around_at_most);
  for (auto& w : windows) shorten(w, longest_side * level.period);
  return windows;
}

std::vector<TurnWindow> around_pauses(const BinnedVolume& level) {
  return around_rests(level, around_at_most);
}

std::vector<TurnWindow> around_tops(const BinnedVolume& bins) {
  std::vector<TurnWindow> windows;
  for (std::size_t i = 0; i < bins.peak.size(); ++i) {
    const auto depth = [&](std::size_t k) { return bins.smooth[bins.trough[k]] - bins.smooth[bins.peak[i]]; };
    windows.push_back(around(bins, bins.peak[i], {bins.trough[i], bins.trough[i + 1], depth(i), depth(i + 1)},
                             bins.around));
  }
  return windows;
}

std::vector<TurnWindow> closely_around_tops(Samples time, Samples depth, const BinnedVolume& bins,
                                            const std::vector<Turn>& known,
                                            const std::vector<TurnWindow>& windows) {
  std::vector<TurnWindow> close;
  for (std::size_t i = 0; i < known.size(); ++i) {
    const auto index = [&](double t) {
      return static_cast<std::size_t>(std::lower_bound(time.begin(), time.end(), t) - time.begin());
    };
    const std::size_t first = index(windows[i].time.front()),
                      last = std::min(index(windows[i].time.back()), time.size() - 1);
    std::size_t from = std::clamp(index(known[i].begin_s), first, last),
                until = std::clamp(index(known[i].end_s), from, last);
    const double lowest = *std::min_element(&depth[from], &depth[until] + 1);
    const double limit = lowest + bins.closely * windows[i].height;
    while (from > first && depth[from - 1] <= limit) --from;
    while (until < last && depth[until + 1] <= limit) ++until;
    from = std::max(from, first + more_samples) - more_samples;
    until = std::min(until + more_samples, last);
    close.push_back({time.subspan(from, until - from + 1),
                     depth.subspan(from, until - from + 1),
                     {},
                     windows[i].sides,
                     windows[i].height});
  }
  return close;
}

std::vector<Turn> turns_in(const std::vector<TurnWindow>& windows, TurnKind kind, double period,
                           NoiseKind noise) {
  std::vector<double> lags(other_lags.begin(), other_lags.end());
  if (kind == TurnKind::onset) {
    lags.assign(onset_lags.begin(), onset_lags.end());
    for (double& lag : lags) lag *= period;
  }
  const TurnShape shape = shape_of(windows, lags, noise);
  std::vector<Turn> turns;
  for (const TurnWindow& w : windows) turns.push_back(fit_turn(w.time, w.volume, shape, w.sides, noise));
  return turns;
}

}  // namespace trunk
