#include "tables/text_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "errors/input_error.hpp"

namespace trunk {
namespace {

constexpr std::string_view blanks = " \t\v\f";

std::string_view unquoted(std::string_view cell) {
  cell = trimmed(cell);
  if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"')
    cell = trimmed(cell.substr(1, cell.size() - 2));
  return cell;
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

bool TextLines::next(std::string_view& line) {
  comment_ = {};
  while (position_ < text_.size()) {
    const auto end = std::min(text_.find_first_of("\r\n", position_), text_.size());
    line = text_.substr(position_, end - position_);
    position_ = end + (text_.substr(end, 2) == "\r\n" ? 2 : 1);
    ++number_;
    if (line.size() > max_line_bytes)
      throw InputError({source_, number_}, fmt::format("a line of {} bytes found", line.size()),
                       fmt::format("at most {} bytes", max_line_bytes),
                       "check that this is a table with one sample per line");
    const std::string_view content = trimmed(line);
    if (content.starts_with('#'))
      comment_ = content.substr(1);
    else if (!content.empty())
      return true;
  }
  return false;
}

bool split_cells(std::string_view line, char delimiter, std::vector<std::string_view>& cells) {
  cells.clear();
  const bool by_blanks = delimiter == ' ';
  if (by_blanks) line = trimmed(line);
  const auto delimits = [&](char c) { return c == delimiter || (by_blanks && c == '\t'); };
  bool in_quotes = false;
  std::size_t start = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') in_quotes = !in_quotes;
    if (!delimits(line[i]) || in_quotes) continue;
    if (!by_blanks || i > start) cells.push_back(unquoted(line.substr(start, i - start)));
    start = i + 1;
  }
  cells.push_back(unquoted(line.substr(start)));
  while (!cells.empty() && cells.back().empty()) cells.pop_back();
  return !in_quotes;
}

// std::from_chars does not depend on the locale, and does not accept a leading '+'.
std::pair<double, std::errc> cell_number(std::string_view cell, bool decimal_comma) {
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

}  // namespace trunk
