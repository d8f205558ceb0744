#include "breaths/above_noise.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "math/median.hpp"

namespace trunk {
namespace {

constexpr std::size_t wide_strides = 16, close_strides = 32, few_samples = 12;
constexpr double enough_heights = 6, enough_of_few = 3;
constexpr double of_normal = 0.6745;  // median absolute value over deviation
constexpr double of_walk = 4.4721;  // root of 20: fourth difference of a walk over the deviation of its step

// Returns how far a walk with the fourth differences of a volume strays in half of its length.
double reach_of(std::span<const double> volume, std::size_t stride) {
  std::vector<double> differences;
  for (std::size_t i = 4 * stride; i < volume.size(); ++i)
    differences.push_back(std::abs(volume[i - 4 * stride] - 4 * volume[i - 3 * stride] +
                                   6 * volume[i - 2 * stride] - 4 * volume[i - stride] + volume[i]));
  const double step = median(std::move(differences)) / (of_normal * of_walk);
  return step * std::sqrt(0.5 * static_cast<double>(volume.size() - 1) / static_cast<double>(stride));
}

// Returns by how much a breath, as a part of its height, is beyond what noise reaches.
double over_noise(std::span<const double> volume, std::size_t peak, std::size_t strides) {
  const std::size_t length = volume.size() - 1;
  const double height = volume[peak] - std::max(volume.front(), volume.back());
  const double reach = reach_of(volume, std::max<std::size_t>(length / strides, 1));
  return height / (length < few_samples ? enough_of_few : enough_heights) - reach;
}

}  // namespace

bool above_noise(std::span<const double> volume, std::size_t first, std::size_t peak, std::size_t last) {
  if (last - first < 4) return true;
  const auto part = volume.subspan(first, last - first + 1);
  return over_noise(part, peak - first, wide_strides) >= 0 ||
         over_noise(part, peak - first, close_strides) >= 0;
}

bool clearly_above_noise(std::span<const double> volume, std::size_t first, std::size_t peak,
                         std::size_t last) {
  if (last - first < 4) return true;
  const auto part = volume.subspan(first, last - first + 1);
  return over_noise(part, peak - first, wide_strides) >= 0 &&
         over_noise(part, peak - first, close_strides) >= 0;
}

}  // namespace trunk
