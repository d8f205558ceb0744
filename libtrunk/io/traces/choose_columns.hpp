#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "recordings/recording.hpp"
#include "tables/column_names.hpp"
#include "traces/trace.hpp"

namespace trunk {

/// Where a recording holds a breathing signal: positions among its channels, with what their names say.
struct TraceColumns {
  std::vector<ColumnName> all;  ///< units as they count, also where an option gave them
  std::optional<std::size_t> time;
  double rate_hz = 0;  ///< where there is no time
  std::size_t value = 0;
  SignalKind kind = SignalKind::volume;
  std::optional<std::size_t> sigma;
  std::vector<std::string> notes;  ///< the choice, when there was one
};

/// Chooses as read_trace describes. Throws InputErrors with the header's line: a column that is absent or
/// named twice, a chosen column without a usable unit; lists what was found and names the nearest, or the
/// option that picks it.
TraceColumns choose_columns(const Recording& recording, const TraceOptions& options);

}  // namespace trunk
