#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace trunk {

/// A time of day, with its date where it has one.
struct ClockTime {
  double seconds = 0;   ///< since midnight, since the hour, or since 1 January 1970 where there is a date
  double period_s = 0;  ///< after which it begins again at 0; 0: never, there is a date
};

/// Reads "14:05:07.25" (also with a decimal comma), "05:07.2" (minutes and seconds), and after a date
/// "2024-03-31T14:05:07", "2024-03-31 14:05:07Z", "31.03.2024 14:05:07", "2024/03/31 14:05:07". Nothing for
/// anything else. A zone at the end is passed over: only differences of times are used.
std::optional<ClockTime> clock_time(std::string_view text);

/// Times of one column as seconds since the first; NaN where there is none. Times that go back by more than
/// half their period have passed midnight, or the full hour.
std::vector<double> seconds_since_first(const std::vector<std::optional<ClockTime>>& times);

}  // namespace trunk
