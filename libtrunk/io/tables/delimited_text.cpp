#include "tables/delimited_text.hpp"

#include <fmt/format.h>

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
      fail(row.line, "a double quote is opened and not closed", "pairs of quotes", "close or remove it");
  } while (row.cells.empty());
  if (++rows_ > max_rows)
    fail(row.line, "too many rows found", fmt::format("at most {}", max_rows), "thin them");
  take_comment(row);
  if (row.cells.size() > names().size())
    fail(row.line, fmt::format("{} cells found", row.cells.size()),
         fmt::format("{} as in the {}", names().size(), named() ? "header" : "first row"),
         layout_.delimiter == ',' ? "if commas are decimal marks, separate the columns by semicolons"
                                  : "name every column");
  return true;
}

void DelimitedText::take_comment(Row& row) const {
  row.comment = {};
  for (std::size_t i = names().size(); i < row.cells.size(); ++i) {
    if (!row.cells[i].starts_with('#')) continue;
    const std::string_view last = row.cells.back();
    row.comment = {row.cells[i].data(),
                   static_cast<std::size_t>(last.data() + last.size() - row.cells[i].data())};
    row.cells.resize(i);
    while (!row.cells.empty() && row.cells.back().empty()) row.cells.pop_back();
    return;
  }
}

std::string_view DelimitedText::text(const Row& row, std::size_t column) const {
  const auto name = [&] { return excerpt(names().at(column)); };
  if (column >= row.cells.size())
    fail(row.line, fmt::format("{} cell(s) found", row.cells.size()),
         fmt::format("at least {}, since column {} is number {}", column + 1, name(), column + 1),
         "complete or remove the row");
  if (row.cells[column].empty())
    fail(row.line, fmt::format("empty cell found in column {}", name()), "a number",
         "fill or remove the row");
  return row.cells[column];
}

double DelimitedText::number(const Row& row, std::size_t column) const {
  const std::string_view cell = text(row, column);
  const auto [value, error] = cell_number(cell, layout_.delimiter != ',');
  if (error == std::errc{} && std::isfinite(value)) return value;
  const bool is_number = error != std::errc::invalid_argument;
  fail(row.line, fmt::format("{} found in column {}", excerpt(cell), excerpt(names()[column])),
       is_number ? "a finite number" : "a number such as 0.25",
       is_number ? "remove the row or interpolate the value" : "correct or remove the row");
}

void DelimitedText::fail(std::size_t line, std::string found, std::string expected,
                         std::string remedy) const {
  throw InputError({source(), line}, std::move(found), std::move(expected), std::move(remedy));
}

}  // namespace trunk
