#include "io/delimited_text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>
#include <utility>

#include "errors/input_error.hpp"
#include "io/message_text.hpp"

namespace trunk {
namespace {

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\v\f");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\v\f") - first + 1);
}

std::string_view unquoted(std::string_view cell) {
  cell = trimmed(cell);
  if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"')
    cell = trimmed(cell.substr(1, cell.size() - 2));
  return cell;
}

// std::from_chars knows no locale, and no leading '+'.
std::pair<double, std::errc> parse(std::string_view cell, bool decimal_comma) {
  std::string with_point;
  const bool has_comma = cell.find(',') != std::string_view::npos;
  if (decimal_comma && has_comma && cell.find('.') == std::string_view::npos) {
    with_point = cell;
    with_point[with_point.find(',')] = '.';
    cell = with_point;
  }
  if (cell.size() > 1 && cell[0] == '+' && cell[1] != '-') cell.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc{}) return {value, error};
  return {value, end == cell.data() + cell.size() ? std::errc{} : std::errc::invalid_argument};
}

char delimiter_of(std::string_view header) {
  bool in_quotes = false, tab = false;
  for (const char c : header) {
    if (c == '"') in_quotes = !in_quotes;
    if (c == ';' && !in_quotes) return ';';
    tab = tab || (c == '\t' && !in_quotes);
  }
  return tab ? '\t' : ',';
}

bool is_comment(std::string_view line) {
  return trimmed(line).starts_with('#');
}

}  // namespace

DelimitedText::DelimitedText(std::string source, std::string text)
    : source_(std::move(source)), text_(std::move(text)) {
  std::string_view line;
  const auto need_line = [&] {
    if (!next_content_line(line))
      fail(0, "only blank lines and comments found; expected a header line and rows of numbers");
  };
  need_line();
  const bool declared = line.size() == 5 && line.starts_with("sep=");
  const char declared_delimiter = declared ? line[4] : ',';
  if (declared) need_line();
  delimiter_ = declared ? declared_delimiter : delimiter_of(line);

  header_line_ = line_;
  std::vector<std::string_view> cells;
  split(line, cells);
  while (!cells.empty() && cells.back().empty()) cells.pop_back();
  if (cells.empty())
    fail(line_, "a line of empty cells found; expected a header line that names the columns");
  if (parse(cells.front(), true).second == std::errc{})
    fail(line_,
         "the first row starts with the number " + excerpt(cells.front()) +
             "; expected a header such as time_s,volume_ml; write one (without '#') above the numbers");
  names_.assign(cells.begin(), cells.end());
}

bool DelimitedText::next(Row& row) {
  std::string_view line;
  do {
    if (!next_content_line(line)) return false;
    split(line, row.cells);
    while (!row.cells.empty() && row.cells.back().empty()) row.cells.pop_back();
  } while (row.cells.empty());
  row.line = line_;
  if (++rows_ > max_rows)
    fail(line_,
         "more than " + std::to_string(max_rows) + " rows found, the most this program reads; thin them");
  if (row.cells.size() > names_.size())
    fail(line_, std::to_string(row.cells.size()) + " cells found; expected " + std::to_string(names_.size()) +
                    " as in the header" +
                    (delimiter_ == ',' ? "; if commas are decimal marks, separate the columns by semicolons"
                                       : "; name every column"));
  return true;
}

double DelimitedText::number(const Row& row, std::size_t column) const {
  const auto name = [&] { return excerpt(names_.at(column)); };
  if (column >= row.cells.size())
    fail(row.line, std::to_string(row.cells.size()) + " cell(s) found; column " + name() + " is number " +
                       std::to_string(column + 1) + "; complete or remove the row");
  const std::string_view cell = row.cells[column];
  if (cell.empty())
    fail(row.line, "empty cell found in column " + name() + "; expected a number; fill or remove the row");
  const auto [value, error] = parse(cell, delimiter_ != ',');
  if (error == std::errc::invalid_argument)
    fail(row.line, excerpt(cell) + " found in column " + name() +
                       "; expected a number such as 0.25; correct or remove the row");
  if (error != std::errc{} || !std::isfinite(value))
    fail(row.line, excerpt(cell) + " found in column " + name() +
                       "; expected a finite number; remove the row or interpolate the value");
  return value;
}

bool DelimitedText::next_line(std::string_view& line) {
  if (position_ >= text_.size()) return false;
  const auto end = std::min(text_.find_first_of("\r\n", position_), text_.size());
  line = std::string_view(text_).substr(position_, end - position_);
  const bool crlf = text_.compare(end, 2, "\r\n") == 0;
  position_ = end + (crlf ? 2 : 1);
  ++line_;
  if (line.size() > max_line_bytes)
    fail(line_, "a line of " + std::to_string(line.size()) + " bytes found; expected at most " +
                    std::to_string(max_line_bytes) + "; check that this is a table with one sample a line");
  return true;
}

bool DelimitedText::next_content_line(std::string_view& line) {
  while (next_line(line))
    if (!is_comment(line) && !trimmed(line).empty()) return true;
  return false;
}

void DelimitedText::split(std::string_view line, std::vector<std::string_view>& cells) const {
  cells.clear();
  bool in_quotes = false;
  std::size_t start = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') in_quotes = !in_quotes;
    if (line[i] != delimiter_ || in_quotes) continue;
    cells.push_back(unquoted(line.substr(start, i - start)));
    start = i + 1;
  }
  if (in_quotes) fail(line_, "a double quote is opened and not closed; expected pairs; remove or close it");
  cells.push_back(unquoted(line.substr(start)));
}

void DelimitedText::fail(std::size_t line, const std::string& text) const {
  throw InputError(source_, line, text);
}

}  // namespace trunk
