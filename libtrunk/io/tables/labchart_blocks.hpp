#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "tables/text_cells.hpp"

namespace trunk {

/// What was recorded between a start and a stop of LabChart: lines such as "Interval=", and rows below them.
struct LabChartBlock {
  using Cells = std::vector<std::string_view>;

  std::map<std::string_view, Cells> keys;  ///< what stands behind "Interval" and so on; views into the text
  std::size_t header_line = 0, count = 0;  ///< count: of the rows
  char delimiter = '\t';
  double interval_s = 0;  ///< 0: not known
  TextLines rows;         ///< is just before the first row, and ends with the last

  Cells values_of(std::string_view key) const;
  /// Returns the length in s; in rows if the interval is not known.
  double length_s() const { return static_cast<double>(count) * (interval_s > 0 ? interval_s : 1); }
};

/// Returns a block of a text that is_labchart (see labchart_layout for `wanted` and errors). Adds a note if
/// the program chose among several.
LabChartBlock labchart_block(const TextLines& lines, std::size_t wanted, std::vector<std::string>& notes);

}  // namespace trunk
