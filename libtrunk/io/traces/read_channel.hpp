#pragma once

#include <string>
#include <vector>

#include "recordings/recording.hpp"
#include "traces/choose_channels.hpp"

namespace trunk {

/// The samples of a recording that a trace has.
struct SamplesUsed {
  std::size_t first = 0;              ///< how many at the beginning were left out
  const std::vector<double>& time_s;  ///< [samples]
};

/// Returns a channel on the samples of the trace. Up to 0.25 s without a number are interpolated; a longer
/// gap stays NaN. Adds notes about both. Throws InputError if the column cannot be read or has a number in
/// less than half of the samples.
TraceChannel read_channel(Recording& recording, const ChannelColumn& column, const std::string& name,
                          const SamplesUsed& used, std::vector<std::string>& notes);

}  // namespace trunk
