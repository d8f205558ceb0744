#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace trunk {

/// Reads the lines of a text, which end in LF, CRLF or CR. A copy continues from the same line.
///
/// A cell in double quotes may hold line breaks (RFC 4180): its lines are one line here. So that a lone quote
/// cannot swallow a table, such a cell has at most 20 breaks and 4096 bytes, and a delimiter or the end of
/// the line follows it (our choice).
class TextLines {
 public:
  static constexpr std::size_t max_line_bytes = 1'000'000;

  /// The text must outlive this object. Messages name `source`.
  TextLines(std::string source, std::string_view text) : source_(std::move(source)), text_(text) {}

  const std::string& source() const { return source_; }
  std::size_t number() const { return number_; }  ///< of the last line that was read, from 1; its first one
  bool at_end() const { return position_ >= text_.size(); }

  /// Reads the next line that is neither blank nor a comment (`#`) into `line`. Returns false at the end.
  /// Throws InputError if a line is longer than max_line_bytes.
  bool next(std::string_view& line);

  /// Reads the next line whatever it holds. Returns false at the end.
  bool next_of_any_kind(std::string_view& line);

  /// Lets the text end where `there`, a later copy of this object, stands.
  void stop_at(const TextLines& there) { text_ = text_.substr(0, there.position_); }

  /// Returns the comment just above the last line that was read, without "#"; empty if there is none.
  std::string_view comment_above() const { return comment_; }

 private:
  std::size_t break_at(std::size_t position) const;
  std::size_t after_break(std::size_t position) const;
  void take_quoted_breaks(std::string_view& line);

  std::string source_;
  std::string_view text_, comment_;
  std::size_t position_ = 0, number_ = 0, more_ = 0;  // more_: breaks within the last line
};

/// Returns a text without spaces at either end.
std::string_view trimmed(std::string_view text);

/// Splits a line into cells, without spaces around them, without quotes and without empty cells at the end.
/// The delimiter ' ' means any number of spaces and tabs. A cell in double quotes may hold delimiters.
/// Returns false if a quote is not closed.
bool split_cells(std::string_view line, char delimiter, std::vector<std::string_view>& cells);

/// Returns the number in a cell, and std::errc{} if the whole cell is one number. `decimal_comma` allows
/// "0,25". NaN and infinity are numbers here.
std::pair<double, std::errc> cell_number(std::string_view cell, bool decimal_comma);

}  // namespace trunk
