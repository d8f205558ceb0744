#include "breaths/merged_breaths.hpp"

#include <algorithm>

#include "breaths/robust.hpp"
#include "math/median.hpp"

namespace trunk {
namespace {

constexpr double suspect_cycle = 1.5, least_parted = 0.6, most_parted = 2, parted_rise = 0.35,
                 whole_rise = 0.4;  // of what is usual
constexpr std::size_t enough_rises = 4;

// Returns the turns inside a cycle, from its first trough to before its last one; those of the cycle itself
// if it is one breath.
std::vector<TurningPoint> parted(std::span<const double> volume, std::span<const double> level,
                                 const TurningPoint& first, const TurningPoint& peak, std::size_t end,
                                 double rise, double cycle) {
  auto turns = turning_points(level.subspan(first.index, end - first.index + 1), rise);
  for (TurningPoint& turn : turns) turn.index += first.index;
  if (!turns.empty() && turns.front().peak) turns.erase(turns.begin());
  if (!turns.empty() && !turns.back().peak) turns.pop_back();
  if (turns.size() < 4) return {first, peak};
  turns.front().index = first.index;
  for (std::size_t k = 0; k < turns.size(); k += 2) {
    const std::size_t until = k + 2 < turns.size() ? turns[k + 2].index : end;
    const double length = static_cast<double>(until - turns[k].index) / cycle;
    const double up = volume[turns[k + 1].index] - volume[turns[k].index],
                 down = volume[turns[k + 1].index] - volume[until];
    if (down <= 0 || std::max(up, down) < whole_rise / parted_rise * rise || length < least_parted ||
        length > most_parted)
      return {first, peak};
  }
  return turns;
}

}  // namespace

std::vector<TurningPoint> with_merged_parted(std::span<const double> volume,
                                             std::vector<TurningPoint> turns) {
  const auto heights = rises(volume, turns);
  if (heights.size() < enough_rises) return turns;
  std::vector<double> cycles;
  for (std::size_t k = 2; k < turns.size(); ++k)
    if (turns[k].peak) cycles.push_back(static_cast<double>(turns[k].index - turns[k - 2].index));
  const double cycle = median(std::move(cycles)), rise = parted_rise * median(heights);
  std::vector<double> level = moving_average(volume, static_cast<std::size_t>(cycle) | 1);
  for (std::size_t i = 0; i < level.size(); ++i) level[i] = volume[i] - level[i];

  std::vector<TurningPoint> all;
  for (std::size_t k = 0; k < turns.size(); ++k) {
    const bool whole = !turns[k].peak && k + 2 < turns.size();
    if (!whole || static_cast<double>(turns[k + 2].index - turns[k].index) < suspect_cycle * cycle) {
      all.push_back(turns[k]);
      continue;
    }
    const auto inside = parted(volume, level, turns[k], turns[k + 1], turns[k + 2].index, rise, cycle);
    all.insert(all.end(), inside.begin(), inside.end());
    ++k;  // its peak is there
  }
  return all;
}

}  // namespace trunk
