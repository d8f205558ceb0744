#pragma once

#include <string>
#include <vector>

#include "tables/text_cells.hpp"

namespace trunk {

/// How a table stands in a text.
struct TableLayout {
  char delimiter = ',';            ///< ';', tab, ',' or ' ' for any number of blanks
  std::size_t header_line = 0;     ///< or the first row's, where nothing names the columns
  bool named = true;               ///< false: then the names are the numbers from 1
  std::vector<std::string> names;  ///< of the columns, at least one
  std::vector<std::string> units;  ///< of a row of units below the header; empty, or as many as names
  TextLines rows;                  ///< stands before the first row
};

/// Finds header and delimiter. Above the header there may be up to 20000 lines of something else, as loggers
/// write it: what counts is the first three lines that hold numbers in two or more cells, and above these the
/// nearest of 30 lines that names a quantity; else the first line of all where it does, else the line right
/// above (all our choice). Between header and numbers there may be lines without numbers, one of them with
/// units. A spreadsheet's `sep=;` declares the delimiter. A comment right above the numbers is the header
/// where it names a quantity and nothing else does. Throws InputError: nothing but blank lines and comments,
/// a first line of empty cells, an open quote in the header.
TableLayout table_layout(TextLines lines);

/// The same of a list, whose rows need not hold numbers: the first line is the header, all below are rows.
TableLayout list_layout(TextLines lines);

}  // namespace trunk
