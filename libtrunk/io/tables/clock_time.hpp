#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace trunk {

/// A time of day, with its date if there is one.
struct ClockTime {
  double seconds = 0;   ///< since midnight, since the full hour, or since 1 January 1970 if there is a date
  double period_s = 0;  ///< after this time it restarts at 0; 0: never, since there is a date
};

/// Returns the time of a text such as "14:05:07.25" (the decimal mark may be a comma), "05:07.2" (minutes and
/// seconds), "00:10:11:403" (three digits after a colon are milliseconds, as ventilators write them),
/// "2:05:07 PM", "2024-03-31T14:05:07", "31.03.2024 14:05:07", "2024/03/31 14:05:07", "31-Mar-2024 14:05:07"
/// or "1 days 02:05:07"; nothing for any other text. A zone may follow: "Z", "+02:00", " UTC", " CEST". An
/// offset in numbers is taken off, so that times go on when summer time ends; names of zones are ignored,
/// because only differences of times are used.
std::optional<ClockTime> clock_time(std::string_view text);

/// Returns the times of one column in seconds since the first, and NaN for a missing time. A time that goes
/// back by more than half its period has passed midnight or the full hour.
std::vector<double> seconds_since_first(const std::vector<std::optional<ClockTime>>& times);

}  // namespace trunk
