#pragma once

#include <string>
#include <vector>

#include "traces/raw_samples.hpp"

namespace trunk {

/// Throws InputErrors if times do not increase. Missing times (NaN) are ignored.
void check_increases(const std::vector<double>& time_s, const RawSamples& samples, const ColumnName& column);

/// Checks the times of samples, and repairs the times of a coarse clock. If three or more samples share their
/// time with the one before, and no time is further from evenly spaced times than the resolution of the clock
/// (our choice), the times become evenly spaced. Adds notes about the repair, about less than 10 or more than
/// 2000 samples per second, and about a rate that at the end is another than at the beginning, by a factor of
/// 1.3 (our choice).
///
/// Throws InputErrors if times do not increase, if a gap is longer than both 10 median steps and 0.25 s, or
/// if there are fewer than 4 samples per second. `column` is the column of the times, or null if the sampling
/// rate gives them.
void settle_times(std::vector<double>& time_s, const RawSamples& samples, const ColumnName* column,
                  std::vector<std::string>& notes);

}  // namespace trunk
