#include "tables/delimited_text.hpp"

#include <cmath>

#include "errors/input_error.hpp"
#include "text/message_text.hpp"

namespace trunk {

void DelimitedText::rewind() {
  lines_ = layout_.rows;
  rows_ = 0;
}

bool DelimitedText::next(Row& row) {
  std::string_view line;
  do {
    if (!lines_.next(line)) return false;
    row.line = lines_.number();
    if (!split_cells(line, layout_.delimiter, row.cells))
      fail(row.line, "a double quote is opened and not closed; expected pairs; remove or close it");
  } while (row.cells.empty());
  if (++rows_ > max_rows)
    fail(row.line,
         "more than " + std::to_string(max_rows) + " rows found, the most this program reads; thin them");
  if (row.cells.size() > names().size())
    fail(row.line,
         std::to_string(row.cells.size()) + " cells found; expected " + std::to_string(names().size()) +
             " as in the " + (named() ? "header" : "first row") +
             (layout_.delimiter == ',' ? "; if commas are decimal marks, separate the columns by semicolons"
                                       : "; name every column"));
  return true;
}

std::string_view DelimitedText::text(const Row& row, std::size_t column) const {
  const auto name = [&] { return excerpt(names().at(column)); };
  if (column >= row.cells.size())
    fail(row.line, std::to_string(row.cells.size()) + " cell(s) found; column " + name() + " is number " +
                       std::to_string(column + 1) + "; complete or remove the row");
  if (row.cells[column].empty())
    fail(row.line, "empty cell found in column " + name() + "; expected a number; fill or remove the row");
  return row.cells[column];
}

double DelimitedText::number(const Row& row, std::size_t column) const {
  const std::string_view cell = text(row, column);
  const auto [value, error] = cell_number(cell, layout_.delimiter != ',');
  if (error == std::errc{} && std::isfinite(value)) return value;
  fail(row.line, excerpt(cell) + " found in column " + excerpt(names()[column]) +
                     (error == std::errc::invalid_argument
                          ? "; expected a number such as 0.25; correct or remove the row"
                          : "; expected a finite number; remove the row or interpolate the value"));
}

void DelimitedText::fail(std::size_t line, const std::string& text) const {
  throw InputError(source(), line, text);
}

}  // namespace trunk
