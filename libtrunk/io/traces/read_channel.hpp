#pragma once

#include <string>
#include <vector>

#include "recordings/recording.hpp"
#include "traces/choose_channels.hpp"
#include "traces/used_samples.hpp"

namespace trunk {

/// Returns a channel on the samples of a trace at these times. Up to 0.25 s without a number are
/// interpolated, so that a channel at another rate in the same rows is too; a longer gap stays NaN. Adds
/// notes about both. Throws InputError if the column cannot be read or has a number in less than half of the
/// samples.
TraceChannel read_channel(Recording& recording, const ChannelColumn& column, const std::string& name,
                          const UsedSamples& used, const std::vector<double>& time_s,
                          std::vector<std::string>& notes);

}  // namespace trunk
