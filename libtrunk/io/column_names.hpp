#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace trunk {

enum class Quantity { time, volume, flow, unknown };

/// What a column header says: `volume_L`, `Volume [L]` and `"VOLUME (l)"` all read base "volume", unit "L".
struct ColumnName {
  std::string text;                       ///< as in the file
  std::string plain;                      ///< lower case, words joined by '_': "flow_l_s"
  std::string base;                       ///< plain without its unit: "flow"
  std::string unit;                       ///< as this program writes it: "L_s"; empty when there is none
  Quantity quantity = Quantity::unknown;  ///< by the unit
  double to_si = 1;                       ///< factor from the unit to s, m3 or m3/s
};

/// Reads a header (UTF-8, any case). Known units: s ms min; ml L; L_s L_min ml_s, and their spellings in
/// words.
ColumnName column_name(std::string_view header);

/// A sentence that names the column which was probably meant as `quantity` and its right name, or "".
std::string suggestion(const std::vector<ColumnName>& columns, Quantity quantity);

/// "'a', 'b', 'c'": the headers of a file for an error text; long lists are cut.
std::string list_of(const std::vector<ColumnName>& columns);

}  // namespace trunk
