#include "breaths/turning_points.hpp"

#include <algorithm>

#include "breaths/above_noise.hpp"
#include "breaths/robust.hpp"
#include "math/median.hpp"

namespace trunk {
namespace {

constexpr double threshold_of_rise = 0.3;
constexpr double least_of_range = 0.001, least_of_noise = 10;
constexpr double clearly_more = 0.1;  // of the record

// Reaches a fixed point within a few rounds: each round only adds or drops rises far from the median.
std::vector<TurningPoint> settled(std::span<const double> signal, double threshold) {
  auto turns = turning_points(signal, threshold);
  for (int round = 0; round < 20; ++round) {
    const double next = threshold_of_rise * median(rises(signal, turns));
    if (next <= 0 || next == threshold) break;
    threshold = next;
    turns = turning_points(signal, threshold);
  }
  return turns;
}

// Returns the part of the record in regular cycles, from trough to trough: those with a height above rest and
// a length within a factor of two of the medians that stand out of the noise. It is less by 1 if the median
// cycle is too long.
double regular_part(std::span<const double> signal, const std::vector<TurningPoint>& turns, double longest) {
  std::vector<double> heights, lengths;
  std::vector<bool> smooth;
  for (std::size_t k = turns.empty() || turns[0].peak ? 1 : 0; k + 2 < turns.size(); k += 2) {
    const double rests = 0.5 * (signal[turns[k].index] + signal[turns[k + 2].index]);
    heights.push_back(signal[turns[k + 1].index] - rests);
    lengths.push_back(static_cast<double>(turns[k + 2].index - turns[k].index));
    smooth.push_back(above_noise(signal, turns[k].index, turns[k + 1].index, turns[k + 2].index));
  }
  const auto usual = [](double value, double middle) { return value > 0.5 * middle && value < 2 * middle; };
  const double height = median(heights), length = median(lengths);
  double part = length > longest ? -1 : 0;
  for (std::size_t i = 0; i < lengths.size(); ++i)
    if (smooth[i] && usual(heights[i], height) && usual(lengths[i], length))
      part += lengths[i] / static_cast<double>(signal.size());
  return part;
}

}  // namespace

std::vector<double> rises(std::span<const double> signal, const std::vector<TurningPoint>& turns) {
  std::vector<double> found;
  for (std::size_t k = 1; k < turns.size(); ++k)
    if (turns[k].peak) found.push_back(signal[turns[k].index] - signal[turns[k - 1].index]);
  return found;
}

std::vector<TurningPoint> turning_points(std::span<const double> signal, double threshold) {
  std::vector<TurningPoint> turns;
  std::size_t low = 0, high = 0;  // extremes since the last turning point
  bool rising = false, falling = false;
  for (std::size_t i = 0; i < signal.size(); ++i) {
    if (signal[i] < signal[low]) low = i;
    if (signal[i] > signal[high]) high = i;
    if (!rising && signal[i] - signal[low] >= threshold) {
      turns.push_back({low, false});
      rising = true, falling = false;
      high = i;
    } else if (!falling && signal[high] - signal[i] >= threshold) {
      turns.push_back({high, true});
      rising = false, falling = true;
      low = i;
    }
  }
  if (rising) turns.push_back({high, true});
  if (falling) turns.push_back({low, false});
  return turns;
}

std::vector<TurningPoint> breath_turning_points(std::span<const double> volume, double longest) {
  const auto [low, high] = std::minmax_element(volume.begin(), volume.end());
  const double range = *high - *low;
  const double least =
      std::min(std::max(least_of_range * range, least_of_noise * noise_deviation(volume)), 0.1 * range);
  std::vector<TurningPoint> best;
  double regular = -2;
  double first = threshold_of_rise * range;
  while (first > least) {
    auto turns = settled(volume, first);
    const double found = regular_part(volume, turns, longest);
    if (found > regular + clearly_more) regular = found, best = std::move(turns);
    first /= 2.0;
  }
  return best;
}

}  // namespace trunk
