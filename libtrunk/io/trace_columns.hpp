#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "io/column_names.hpp"
#include "io/delimited_text.hpp"
#include "io/trace.hpp"

namespace trunk {

/// Where a table holds a breathing signal: positions in its header, with what the names say.
struct TraceColumns {
  std::vector<ColumnName> all;
  std::size_t time = 0;
  std::size_t value = 0;
  std::optional<std::size_t> sigma;
  std::vector<std::string> notes;  ///< the choice, when there was one
};

/// Chooses by header as read_trace describes. Throws InputError with the header's line: a column that is
/// absent or named twice, a chosen column without a usable unit; lists what was found and the nearest name.
TraceColumns choose_columns(const DelimitedText& table, const TraceOptions& options);

}  // namespace trunk
