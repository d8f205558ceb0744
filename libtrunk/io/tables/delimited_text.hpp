#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "tables/table_layout.hpp"

namespace trunk {

/// A table in text: names, possibly a row of units, and rows of data; table_layout finds them. Lines that
/// begin with `#` are comments, and so is the rest of a row from a cell that begins with `#` behind the last
/// column. Blank lines and rows of empty cells are skipped. A number may have a decimal comma, unless the
/// comma separates the columns.
///
/// All functions throw InputError with source and line.
class DelimitedText {
 public:
  struct Row {
    std::size_t line = 0;
    std::vector<std::string_view> cells;  ///< trimmed, without quotes; views into the table's text
    std::string_view comment;             ///< at the end of the row, from "#" on; usually empty
  };

  static constexpr std::size_t max_rows = 10'000'000;

  using Layout = std::function<TableLayout(const TextLines&)>;

  /// Reads the header; throws as the layout does.
  DelimitedText(std::string source, std::string text, const Layout& layout = &table_layout)
      : text_(std::move(text)), layout_(layout(TextLines(std::move(source), text_))) {}

  // Rows refer to the text, so the table cannot be copied or moved.
  DelimitedText(const DelimitedText&) = delete;
  DelimitedText& operator=(const DelimitedText&) = delete;

  const std::string& source() const { return layout_.rows.source(); }
  std::size_t header_line() const { return layout_.header_line; }
  bool named() const { return layout_.named; }  ///< false: the names are numbers from 1
  const std::vector<std::string>& names() const { return layout_.names; }
  const std::vector<std::string>& units() const { return layout_.units; }  ///< empty, or as many as names
  double rate_hz() const { return layout_.rate_hz; }                       ///< 0: the file does not say it
  const std::vector<std::string>& notes() const { return layout_.notes; }

  /// Reads the next row of data into `row`. Returns false at the end. Throws if there are too many rows, if
  /// the line is too long, if a quote is not closed or if the row has more cells than there are names.
  bool next(Row& row);
  void rewind();  ///< goes back to the first row

  /// Returns the text of a cell; throws if the cell does not exist or is empty.
  std::string_view text(const Row& row, std::size_t column) const;
  /// Returns the finite number in a cell; throws if the cell does not hold one.
  double number(const Row& row, std::size_t column) const;

 private:
  void take_comment(Row& row) const;
  [[noreturn]] void fail(std::size_t line, std::string found, std::string expected, std::string remedy) const;

  std::string text_;
  TableLayout layout_;  // refers to text_
  TextLines lines_ = layout_.rows;
  std::size_t rows_ = 0;
};

}  // namespace trunk
