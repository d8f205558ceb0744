#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace trunk {

/// A table in text: one header line of names, then rows; `#` lines are comments, blank lines and rows of
/// empty cells are skipped. The delimiter is found in the header: semicolon, else tab, else comma (or a
/// spreadsheet's `sep=;` line). With semicolon or tab a number may have a decimal comma. Lines end in LF,
/// CRLF or CR. A cell in double quotes may hold delimiters, not line breaks.
///
/// All errors are InputError with source and line.
class DelimitedText {
 public:
  struct Row {
    std::size_t line = 0;
    std::vector<std::string_view> cells;  ///< trimmed, without quotes; views into the table's text
  };

  static constexpr std::size_t max_line_bytes = 1'000'000;
  static constexpr std::size_t max_rows = 10'000'000;

  /// Reads the header. Errors: no line at all, a first line that starts with a number, a line over the bound.
  DelimitedText(std::string source, std::string text);

  // Rows view the text, so the table stays where it is.
  DelimitedText(const DelimitedText&) = delete;
  DelimitedText& operator=(const DelimitedText&) = delete;

  const std::string& source() const { return source_; }
  std::size_t header_line() const { return header_line_; }
  const std::vector<std::string>& names() const { return names_; }

  /// The next row of data => row; false at the end. Errors: too many rows, a line over the bound, an open
  /// quote, more filled cells than the header has names.
  bool next(Row& row);

  /// The cell `row.cells[column]` as a finite number. Errors: no such cell, empty, not a number, NaN or
  /// infinite.
  double number(const Row& row, std::size_t column) const;

 private:
  bool next_line(std::string_view& line);
  bool next_content_line(std::string_view& line);
  void split(std::string_view line, std::vector<std::string_view>& cells) const;
  [[noreturn]] void fail(std::size_t line, const std::string& text) const;

  std::string source_;
  std::string text_;
  std::size_t position_ = 0;
  std::size_t line_ = 0;
  std::size_t rows_ = 0;
  std::size_t header_line_ = 0;
  char delimiter_ = ',';
  std::vector<std::string> names_;
};

}  // namespace trunk
