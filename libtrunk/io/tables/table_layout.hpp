#pragma once

#include <string>
#include <vector>

#include "tables/text_cells.hpp"

namespace trunk {

/// Where the parts of a table are in a text.
struct TableLayout {
  char delimiter = ',';            ///< ';', tab, ',' or ' ' for any number of spaces
  std::size_t header_line = 0;     ///< the first row, if nothing names the columns
  bool named = true;               ///< false: the names are numbers from 1
  std::vector<std::string> names;  ///< of the columns, at least one
  std::vector<std::string> units;  ///< from a row of units below the header; empty, or as many as names
  TextLines rows;                  ///< is just before the first row
  double rate_hz = 0;  ///< rows per second; 0: the file does not say it, or a column has the times
  std::vector<std::string> notes{};  ///< messages about the choice of rows
};

/// Finds the header, the delimiter and the first row of a table. All rules are our choice:
///  - Up to 20000 lines of other text may come first, as loggers write them.
///  - The rows begin at the first three consecutive lines with numbers in two or more cells.
///  - The header is the nearest of the 30 lines above the rows that names a quantity, or else the first line
///    of the text if it names one, or else the line just above the rows.
///  - Lines without numbers may stand between header and rows, and one of them may hold units.
///  - The line `sep=;` of a spreadsheet declares the delimiter.
///  - A comment just above the rows is the header if it names a quantity and no line does.
///  - A row in which all cells but one are empty, as of channels at different rates, is a row among others.
///
/// Throws InputError if there are only blank lines and comments, if the header is a line of empty cells, or
/// if a quote in the header is not closed.
TableLayout table_layout(const TextLines& lines);

/// Finds the parts of a list, whose rows need not hold numbers: the first line is the header, and all other
/// lines are rows. Throws as table_layout does.
TableLayout list_layout(const TextLines& lines);

}  // namespace trunk
