#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "tables/table_layout.hpp"

namespace trunk {

/// A table in text: names, perhaps a row of units, then rows of data; see table_layout for how these are
/// found.
/// `#` lines are comments, blank lines and rows of empty cells are skipped. Where the comma does not delimit,
/// a number may have a decimal comma.
///
/// All errors are InputError with source and line.
class DelimitedText {
 public:
  struct Row {
    std::size_t line = 0;
    std::vector<std::string_view> cells;  ///< trimmed, without quotes; views into the table's text
  };

  static constexpr std::size_t max_rows = 10'000'000;

  using Layout = TableLayout (*)(TextLines);

  /// Reads the header. Errors: those of the layout.
  DelimitedText(std::string source, std::string text, Layout layout = &table_layout)
      : text_(std::move(text)), layout_(layout(TextLines(std::move(source), text_))) {}

  // Rows view the text, so the table stays where it is.
  DelimitedText(const DelimitedText&) = delete;
  DelimitedText& operator=(const DelimitedText&) = delete;

  const std::string& source() const { return layout_.rows.source(); }
  std::size_t header_line() const { return layout_.header_line; }
  bool named() const { return layout_.named; }  ///< false: names are numbers from 1
  const std::vector<std::string>& names() const { return layout_.names; }
  const std::vector<std::string>& units() const { return layout_.units; }  ///< empty, or as many as names

  /// The next row of data => row; false at the end. Errors: too many rows, a line over the bound, an open
  /// quote, more filled cells than there are names.
  bool next(Row& row);
  void rewind();  ///< to the first row

  /// The cell `row.cells[column]` in text. Errors: no such cell, or empty.
  std::string_view text(const Row& row, std::size_t column) const;
  /// The same as a finite number. Errors: also not a number, NaN or infinite.
  double number(const Row& row, std::size_t column) const;

 private:
  [[noreturn]] void fail(std::size_t line, const std::string& text) const;

  std::string text_;
  TableLayout layout_;  // views text_
  TextLines lines_ = layout_.rows;
  std::size_t rows_ = 0;
};

}  // namespace trunk
