#include "breaths/binned_volume.hpp"

#include <algorithm>
#include <cmath>

#include "breaths/robust.hpp"
#include "math/median.hpp"

namespace trunk {
namespace {

constexpr double bins_per_breath = 200;
constexpr double around_turn = 0.1;  // fitted part of a height
constexpr double noise_share = 8;    // deviations of the bins that are added
constexpr double around_closely = 0.005, close_noise = 40, close_walk = 6;  // the same, closely around a top
constexpr double clear_walk = 0.003;                                        // of a height

using Samples = std::span<const double>;

// Returns the median absolute fourth difference over a stride.
double fourth_difference(Samples v, std::size_t stride) {
  std::vector<double> differences;
  for (std::size_t i = 4 * stride; i < v.size(); ++i)
    differences.push_back(std::abs(v[i - 4 * stride] - 4 * v[i - 3 * stride] + 6 * v[i - 2 * stride] -
                                   4 * v[i - stride] + v[i]));
  return median(std::move(differences));
}

// Returns how far the noise of the bins strays in a tenth of a breath if it is a walk. Fourth differences of
// a walk grow with their stride, and those of white noise do not: 70 s^2 + 20 stride w^2. What grows faster
// is no noise. A stride is a fortieth of a breath, over which the breath itself has none.
double walk_of(const BinnedVolume& bins) {
  constexpr double strides_per_breath = 40, grows = 1.3, grows_at_most = 2;
  const double step_s = (bins.time.back() - bins.time.front()) / static_cast<double>(bins.time.size() - 1);
  const auto stride = static_cast<std::size_t>(bins.period / strides_per_breath / step_s);
  if (stride < 2) return 0;
  const double one = fourth_difference(bins.volume, 1), wide = fourth_difference(bins.volume, stride);
  if (wide < grows * one || wide > grows_at_most * std::sqrt(static_cast<double>(stride)) * one) return 0;
  const double step =
      std::sqrt((wide * wide - one * one) / (20.0 * static_cast<double>(stride - 1))) / 0.6745;
  return step * std::sqrt(0.1 * bins.period / step_s);
}

}  // namespace

std::size_t bin_at(Samples begins, double time) {
  return static_cast<std::size_t>(std::upper_bound(begins.begin(), begins.end(), time) - begins.begin()) - 1;
}

BinnedVolume::BinnedVolume(Samples time_s, Samples samples, const WholeBreaths& breaths) {
  std::vector<double> durations;
  for (std::size_t i = 1; i < breaths.trough.size(); ++i)
    durations.push_back(time_s[breaths.trough[i]] - time_s[breaths.trough[i - 1]]);
  period = median(std::move(durations));
  std::vector<double> begins;
  for (std::size_t i = 0; i < time_s.size();) {
    begins.push_back(time_s[i]);
    const double end = time_s[i] + period / bins_per_breath;
    double t = 0, v = 0, count = 0;
    do t += time_s[i], v += samples[i], ++count, ++i;
    while (i < time_s.size() && time_s[i] < end);
    time.push_back(t / count);
    volume.push_back(v / count);
  }
  for (const std::size_t i : breaths.trough) trough.push_back(bin_at(begins, time_s[i]));
  for (const std::size_t i : breaths.peak) peak.push_back(bin_at(begins, time_s[i]));
}

BinnedVolume BinnedVolume::above(const KnotLine& rest, double slope_outside, double height,
                                 double sign) const {
  BinnedVolume level = *this;
  for (std::size_t i = 0; i < time.size(); ++i)
    level.volume[i] = sign * (volume[i] - rest(time[i], slope_outside));
  const double of_bins = noise_deviation(level.volume);
  const std::size_t width = averaging_width(of_bins, 0.01 * height, 5);
  level.smooth = moving_average(level.volume, width);
  level.noise = of_bins / std::sqrt(static_cast<double>(width));
  level.around = std::min(around_turn + noise_share * of_bins / height, around_at_most);
  level.walk = walk_of(level);
  level.closely = around_closely + (close_noise * of_bins + close_walk * level.walk) / height;
  if (level.walk > clear_walk * height) level.kind = NoiseKind::walk, level.around = around_at_most;
  return level;
}

}  // namespace trunk
