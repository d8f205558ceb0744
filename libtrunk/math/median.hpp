#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace trunk {

/// Returns the upper median: the middle value or, of an even number, the larger of the two middle ones. It is
/// always one of the values, as a threshold or the tick of a clock has to be. values: [1 or more].
inline double upper_median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Returns the median: the middle value or, of an even number, the mean of the two middle ones; 0 if there
/// are no values.
inline double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

}  // namespace trunk
