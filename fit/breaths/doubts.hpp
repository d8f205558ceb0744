#pragma once

#include <string>
#include <vector>

#include "traces/trace.hpp"

namespace trunk {

/// Returns what looks odd about a trace and may still be right, a sentence each:
///
/// * breaths under 150 ml that take more than 2.5 s: an infant breathes faster, an adult more;
/// * a volume that stays beyond 12 L and drifts by less than half of that: no lung holds so much, but a
///   temperature of 34 °C looks like it;
/// * what change_of_unit finds.
///
/// `time_s` and `volume_m3` are those of the breaths. The size is not judged unless it is `calibrated`. All
/// limits are our choice.
std::vector<std::string> doubts(const Trace& trace, const std::vector<double>& time_s,
                                const std::vector<double>& volume_m3, bool calibrated, double tidal_volume_m3,
                                double period_s);

/// Returns a sentence about a volume that is 6 times as large in one part of the recording as in the rest,
/// before or after: its unit may have changed; or "". Its size is the range from the 5th to the 95th
/// percentile about a line, in each piece of 1.5 breaths; both parts last two pieces at least, and one may
/// lie between them (our choice).
std::string change_of_unit(const std::vector<double>& time_s, const std::vector<double>& volume_m3,
                           double period_s);

}  // namespace trunk
