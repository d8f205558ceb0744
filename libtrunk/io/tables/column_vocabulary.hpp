#pragma once

#include <span>
#include <string_view>

#include "tables/column_names.hpp"
#include "tables/unit_text.hpp"

/// Private to the tables layer: the words of column headers, in lower case and joined by "_".
namespace trunk {

struct UnitSpelling {
  std::string_view suffix;  ///< of a name: "_ml"
  std::string_view name;    ///< in this program
  Quantity quantity;
  double to_si;
};

/// Returns all spellings of units. A volume over a time is a flow, and is not listed again.
std::span<const UnitSpelling> unit_spellings();

/// Returns the gas conditions that spirometers write after a unit, such as "_btps".
std::span<const std::string_view> gas_conditions();

struct ColumnWord {
  std::string_view text;
  Role role;
};

/// Returns the words that give a column its role.
std::span<const ColumnWord> column_words();

/// Returns the words that do not change the role of a column. "resp", "breathing" and "chest" mean a belt if
/// they stand alone.
std::span<const std::string_view> ignored_words();

}  // namespace trunk
