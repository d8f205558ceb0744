#pragma once

#include <string>
#include <vector>

#include "traces/raw_samples.hpp"

namespace trunk {

/// Throws InputErrors where times do not increase; those that are missing (NaN) are passed over.
void check_increases(const std::vector<double>& time_s, const RawSamples& samples, const ColumnName& column);

/// Checks the times of samples, in s and one each, and repairs what can be: where the clock was so coarse
/// that samples share their times (three or more, and evenly: none is further from an even course than the
/// clock's resolution, our choice) they are spread over that course. Adds notes, also on less than 10 or more
/// than 2000 samples a second.
///
/// Throws InputErrors: times that do not increase, gaps of more than 10 median steps and 0.25 s, less than 4
/// samples a second. `column` names the times and their unit; null where they are counted.
void settle_times(std::vector<double>& time_s, const RawSamples& samples, const ColumnName* column,
                  std::vector<std::string>& notes);

}  // namespace trunk
