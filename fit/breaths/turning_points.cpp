#include "breaths/turning_points.hpp"

#include <algorithm>

#include "breaths/robust.hpp"

namespace trunk {
namespace {

constexpr double threshold_of_rise = 0.3;
constexpr double least_of_range = 0.1;

std::vector<double> rises(std::span<const double> signal, const std::vector<TurningPoint>& turns) {
  std::vector<double> found;
  for (std::size_t k = 1; k < turns.size(); ++k)
    if (turns[k].peak) found.push_back(signal[turns[k].index] - signal[turns[k - 1].index]);
  return found;
}

}  // namespace

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

std::vector<TurningPoint> breath_turning_points(std::span<const double> volume) {
  const auto [low, high] = std::minmax_element(volume.begin(), volume.end());
  const double range = *high - *low;
  double threshold = threshold_of_rise * range;
  auto turns = turning_points(volume, threshold);
  while (rises(volume, turns).size() < 2 && threshold > least_of_range * range) {
    threshold /= 2;
    turns = turning_points(volume, threshold);
  }
  // A fixed point within a few rounds, as each round only adds or drops rises far from the median.
  for (int round = 0; round < 20; ++round) {
    const double next = threshold_of_rise * median(rises(volume, turns));
    if (next <= 0 || next == threshold) break;
    threshold = next;
    turns = turning_points(volume, threshold);
  }
  return turns;
}

}  // namespace trunk
