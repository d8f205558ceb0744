#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

/// Private to the breaths layer.
namespace trunk {

/// Fewer breaths than this do not show a standard deviation (our choice).
inline constexpr std::size_t enough_for_deviation = 3;

/// Returns the mean of some values (at least one).
inline double mean_of(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

/// Returns the standard deviation of some values (at least two).
inline double deviation_of(const std::vector<double>& values) {
  const double mean = mean_of(values);
  double sum = 0;
  for (const double value : values) sum += (value - mean) * (value - mean);
  return std::sqrt(sum / static_cast<double>(values.size() - 1));
}

}  // namespace trunk
