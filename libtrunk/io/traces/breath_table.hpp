#pragma once

#include <string>
#include <vector>

#include "tables/column_names.hpp"

namespace trunk {

/// Returns the names of the columns which show that each row of a table is a breath, as metabolic carts write
/// them: "'VT', 'VO2', 'VCO2'". Returns "" if fewer than three columns are numbers of a breath (our choice).
std::string numbers_of_breaths(const std::vector<ColumnName>& columns);

/// What to do with such a table.
inline constexpr auto remedy_for_breath_table =
    "export flow or volume themselves, 25 or more samples a second (raw data, waveforms)";

}  // namespace trunk
