#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace trunk {

/// The lines of a text, one after another. Lines end in LF, CRLF or CR. A copy goes on from the same place.
class TextLines {
 public:
  static constexpr std::size_t max_line_bytes = 1'000'000;

  /// The text must outlive this; `source` is for messages.
  TextLines(std::string source, std::string_view text) : source_(std::move(source)), text_(text) {}

  const std::string& source() const { return source_; }
  std::size_t number() const { return number_; }  ///< of the last line taken, from 1
  bool at_end() const { return position_ >= text_.size(); }

  /// The next line that is neither blank nor a comment (`#`) => line; false at the end. Throws InputError: a
  /// line over the bound.
  bool next(std::string_view& line);

  /// The comment right above the last line taken, without its mark; empty where there is none.
  std::string_view comment_above() const { return comment_; }

 private:
  std::string source_;
  std::string_view text_, comment_;
  std::size_t position_ = 0, number_ = 0;
};

/// Without blanks at either end.
std::string_view trimmed(std::string_view text);

/// A line => its cells, trimmed and without quotes; empty cells at the end are dropped. A blank as delimiter
/// means any number of blanks and tabs. A cell in double quotes may hold delimiters. False where a quote is
/// not closed.
bool split_cells(std::string_view line, char delimiter, std::vector<std::string_view>& cells);

/// A cell as a number; `decimal_comma` allows "0,25". The error is std::errc{} where all of it is one number;
/// NaN and infinity are numbers here.
std::pair<double, std::errc> cell_number(std::string_view cell, bool decimal_comma);

}  // namespace trunk
