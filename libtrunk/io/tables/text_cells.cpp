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

std::size_t TextLines::break_at(std::size_t position) const {
  return std::min(text_.find_first_of("\r\n", position), text_.size());
}

std::size_t TextLines::after_break(std::size_t position) const {
  return std::min(position + (text_.substr(position, 2) == "\r\n" ? 2 : 1), text_.size());
}

bool TextLines::next_of_any_kind(std::string_view& line) {
  if (at_end()) return false;
  const std::size_t end = break_at(position_);
  line = text_.substr(position_, end - position_);
  position_ = after_break(end);
  number_ += 1 + more_;
  more_ = 0;
  if (line.size() > max_line_bytes)
    throw InputError({source_, number_}, fmt::format("a line of {} bytes found", line.size()),
                     fmt::format("at most {} bytes", max_line_bytes),
                     "check that this is a table with one sample per line");
  return true;
}

// Lets the line go on to the end of a quoted cell that has line breaks, if there is one. => line
void TextLines::take_quoted_breaks(std::string_view& line) {
  constexpr std::size_t most_breaks = 20, most_bytes = 4096;
  const auto delimits = [](char c) { return c == ',' || c == ';' || c == '\t'; };
  const auto start = static_cast<std::size_t>(line.data() - text_.data());
  bool in_quotes = false;
  std::size_t opened = 0;
  const auto look_at = [&](std::size_t i) {
    if (text_[i] != '"') return true;
    in_quotes = !in_quotes;
    if (in_quotes) opened = i;
    const std::size_t after = i + 1;
    return in_quotes || after >= text_.size() || delimits(text_[after]) ||
           std::string_view("\r\n\"").find(text_[after]) != std::string_view::npos;
  };
  std::size_t all_breaks = 0, breaks = 0;  // breaks: in this cell
  const auto end_record = [&](std::size_t end) {
    line = text_.substr(start, end - start);
    position_ = after_break(end);
    more_ = all_breaks;
  };
  for (std::size_t i = start; i < start + line.size(); ++i) look_at(i);
  if (!in_quotes || (opened > start && !delimits(text_[opened - 1]))) return;
  for (std::size_t i = start + line.size(); i < text_.size() && i - start <= max_line_bytes;) {
    const bool at_break = text_[i] == '\r' || text_[i] == '\n';
    if (at_break && !in_quotes) return end_record(i);
    if (at_break) {
      if (++breaks > most_breaks) return;
      ++all_breaks;
      i = after_break(i);
    } else {
      const bool was_in_quotes = in_quotes;
      if (!look_at(i)) return;
      if (in_quotes && !was_in_quotes) breaks = 0;
      ++i;
    }
    if (in_quotes && i - opened > most_bytes) return;
    if (i >= text_.size() && !in_quotes) return end_record(i);
  }
}

bool TextLines::next(std::string_view& line) {
  comment_ = {};
  while (next_of_any_kind(line)) {
    const std::string_view content = trimmed(line);
    if (content.starts_with('#')) {
      comment_ = content.substr(1);
    } else if (!content.empty()) {
      if (line.find('"') != std::string_view::npos) take_quoted_breaks(line);
      return true;
    }
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
