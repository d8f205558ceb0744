#include "breaths/whole_breaths.hpp"

#include <algorithm>
#include <optional>

#include "breaths/merged_breaths.hpp"
#include "breaths/robust.hpp"
#include "breaths/shallow_breaths.hpp"
#include "breaths/turning_points.hpp"
#include "math/median.hpp"

namespace trunk {
namespace {

constexpr double rest_tolerance = 0.1;  // of a height
constexpr double clear_of_edge = 0.1;   // of a cycle
constexpr std::size_t many_breaths = 4;
constexpr double longest_breath_s = 30;

using Samples = std::span<const double>;
using Turns = std::vector<TurningPoint>;

std::vector<double> without_line(Samples time, Samples volume) {
  const auto n = static_cast<double>(time.size());
  double mean_time = 0, mean_volume = 0, covariance = 0, variance = 0;
  for (std::size_t i = 0; i < time.size(); ++i) {
    mean_time += time[i] / n;
    mean_volume += volume[i] / n;
  }
  for (std::size_t i = 0; i < time.size(); ++i) {
    covariance += (time[i] - mean_time) * (volume[i] - mean_volume);
    variance += (time[i] - mean_time) * (time[i] - mean_time);
  }
  std::vector<double> remainder(volume.begin(), volume.end());
  for (std::size_t i = 0; i < time.size(); ++i) remainder[i] -= covariance / variance * (time[i] - mean_time);
  return remainder;
}

// Returns the volume averaged so much that 8 deviations of its noise (from lowest to highest) are within a
// tenth of the range.
std::vector<double> averaged_for_turns(Samples volume) {
  const auto [low, high] = std::minmax_element(volume.begin(), volume.end());
  const double allowed = 0.1 * (*high - *low) / 8;
  return moving_average(volume, averaging_width(noise_deviation(volume), allowed, volume.size() / 100));
}

struct Found {
  Turns turns;
  std::vector<double> heights;
};

Found turns_in(Samples time, const std::vector<double>& level) {
  const double step = (time.back() - time.front()) / static_cast<double>(time.size() - 1);
  Turns turns = breath_turning_points(level, longest_breath_s / step);
  auto heights = rises(level, turns);
  turns = with_merged_parted(level, with_shallow_breaths(level, std::move(turns)));
  return {std::move(turns), std::move(heights)};
}

// A line through many breaths is their drift, so it is removed; a line through a few breaths depends on where
// the record cuts them.
Found turns_of(Samples time, Samples volume) {
  auto found = turns_in(time, averaged_for_turns(without_line(time, volume)));
  return found.heights.size() >= many_breaths ? found : turns_in(time, averaged_for_turns(volume));
}

// Returns the troughs between two peaks: these are rests.
std::vector<std::size_t> inner_troughs(const Turns& turns) {
  std::vector<std::size_t> inner;
  for (std::size_t k = 1; k + 1 < turns.size(); ++k)
    if (!turns[k].peak) inner.push_back(turns[k].index);
  return inner;
}

double drift_through(Samples time, Samples volume, const std::vector<std::size_t>& troughs) {
  std::vector<double> slopes;
  for (std::size_t i = 1; i < troughs.size(); ++i)
    slopes.push_back((volume[troughs[i]] - volume[troughs[i - 1]]) /
                     (time[troughs[i]] - time[troughs[i - 1]]));
  return median(std::move(slopes));
}

// Returns the drift at one end of the record, from the three rests there, because it may differ.
double drift_near(Samples time, Samples volume, const std::vector<std::size_t>& inner, bool front,
                  double drift) {
  constexpr std::size_t few = 3;
  if (inner.size() < few) return drift;
  const auto begin = front ? inner.begin() : inner.end() - few;
  return drift_through(time, volume, {begin, begin + few});
}

// Drops breaths that the record cuts. The first and the last turn are rests if the record continues beyond
// them, or if they are at the level of the nearest other rest. => turns
void drop_cut_breaths(Samples time, Samples volume, const std::vector<std::size_t>& inner,
                      const WholeBreaths& found, Turns& turns) {
  const auto at_rest = [&](std::size_t sample, std::size_t other) {
    const double drift = drift_near(time, volume, inner, sample < other, found.drift);
    const double rise = volume[sample] - volume[other] - drift * (time[sample] - time[other]);
    return rise <= rest_tolerance * found.height;
  };
  const std::size_t first = turns.front().index, last = turns.back().index;
  const auto inside = [&](std::size_t from, std::size_t until) {
    const auto cycle = static_cast<double>(last - first) / static_cast<double>(inner.size() + 1);
    return static_cast<double>(until - from) > clear_of_edge * cycle;
  };
  const bool first_cut =
      turns.front().peak || (!inside(0, first) && !at_rest(first, inner.empty() ? last : inner.front()));
  const bool last_cut = turns.back().peak || (!inside(last, volume.size() - 1) &&
                                              !at_rest(last, inner.empty() ? first : inner.back()));
  if (last_cut) turns.pop_back();
  if (first_cut) turns.erase(turns.begin());
  if (!turns.empty() && turns.front().peak) turns.erase(turns.begin());
  if (!turns.empty() && turns.back().peak) turns.pop_back();
}

// Returns the samples from one peak to the next, the median; all samples if there is one peak.
std::size_t usual_cycle(Samples volume, const Turns& turns) {
  std::vector<double> cycles;
  std::optional<std::size_t> last;
  for (const TurningPoint& turn : turns) {
    if (!turn.peak) continue;
    if (last) cycles.push_back(static_cast<double>(turn.index - *last));
    last = turn.index;
  }
  return cycles.empty() ? volume.size() : static_cast<std::size_t>(median(std::move(cycles)));
}

// Returns the sample between two that is farthest below the line through them.
std::size_t knee(Samples volume, std::size_t first, std::size_t last) {
  const double slope = (volume[last] - volume[first]) / static_cast<double>(last - first);
  std::size_t found = first;
  double lowest = 0;
  for (std::size_t i = first; i <= last; ++i)
    if (const double v = volume[i] - volume[first] - slope * static_cast<double>(i - first); v < lowest)
      lowest = v, found = i;
  return found;
}

// Brings rests near to their breaths. In a long pause, and before and after breathing, the lowest sample may
// be anywhere. There a rest is where the volume begins to rise, and the last one is where it ends to fall. =>
// turns
void bring_rests_near(Samples volume, Turns& turns) {
  const std::size_t usual = usual_cycle(volume, turns);
  for (std::size_t k = 0; k + 1 < turns.size(); ++k)
    if (turns[k + 1].peak && turns[k + 1].index - turns[k].index > usual)
      turns[k].index = knee(volume, turns[k].index, turns[k + 1].index);
  if (turns.size() < 2 || turns.back().peak) return;
  const std::size_t peak = turns[turns.size() - 2].index;
  if (turns.back().index - peak > usual) turns.back().index = knee(volume, peak, turns.back().index);
}

// Extends the last expiration to the end of the record, or to one and a half usual cycles from its peak,
// unless the next inspiration has begun. => turns
void extend_to_end(Samples time, Samples volume, const WholeBreaths& found, Turns& turns) {
  const std::size_t usual = turns[turns.size() - 2].index + usual_cycle(volume, turns) * 3 / 2;
  const std::size_t end = std::min(volume.size() - 1, std::max(usual, turns.back().index));
  const std::size_t last = turns.back().index;
  const double rise = volume[end] - volume[last] - found.drift * (time[end] - time[last]);
  if (rise <= rest_tolerance * found.height) turns.back().index = end;
}

}  // namespace

WholeBreaths whole_breaths(Samples time_s, Samples volume_m3) {
  auto [turns, heights] = turns_of(time_s, volume_m3);
  WholeBreaths found;
  found.inspirations = heights.size();
  if (turns.size() < 3) return found;

  const auto level = averaged_for_turns(volume_m3);
  bring_rests_near(level, turns);
  const auto inner = inner_troughs(turns);
  const TurningPoint last = turns.back();
  found.height = median(heights);
  found.drift = drift_through(time_s, level, inner);
  drop_cut_breaths(time_s, level, inner, found, turns);
  if (turns.size() < 3) return found;
  if (turns.back().index == last.index) extend_to_end(time_s, level, found, turns);
  for (const auto& turn : turns) (turn.peak ? found.peak : found.trough).push_back(turn.index);
  return found;
}

}  // namespace trunk
