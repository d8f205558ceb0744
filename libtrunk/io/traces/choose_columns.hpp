#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "recordings/recording.hpp"
#include "tables/column_names.hpp"
#include "traces/choose_channels.hpp"
#include "traces/trace.hpp"

namespace trunk {

/// The channels of a recording that hold the breathing signal, and the content of all names.
struct TraceColumns {
  std::vector<ColumnName> all;  ///< with the units that count, possibly from an option
  std::optional<std::size_t> time;
  double rate_hz = 0;  ///< samples per second if there is no time
  std::size_t value = 0;
  SignalKind kind = SignalKind::volume;
  std::optional<std::size_t> sigma;
  std::optional<std::size_t> other;  ///< the volume beside a flow, or the flow beside a volume
  bool unit_by_user = false;         ///< --unit gives that of the signal
  ChosenChannels channels;
  std::vector<std::string> notes;  ///< messages about the choice
};

/// Chooses the channels as read_trace describes. Throws InputErrors with the line of the header if a column
/// is missing or occurs twice, or if a chosen column has no usable unit. The errors list the columns and
/// suggest the most similar name or an option.
TraceColumns choose_columns(const Recording& recording, const TraceOptions& options);

}  // namespace trunk
