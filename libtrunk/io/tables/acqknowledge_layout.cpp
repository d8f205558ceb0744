#include "tables/acqknowledge_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "tables/clock_time.hpp"
#include "tables/column_names.hpp"
#include "tables/leading_number.hpp"

namespace trunk {
namespace {

constexpr std::size_t farthest_rate = 5;  // lines from the first
constexpr double most_channels = 1000;

using Cells = std::vector<std::string_view>;

// Returns the rate in Hz of a line such as "10 msec/sample", "100 samples/sec" or "1 kHz".
std::optional<double> rate_in(std::string_view line) {
  const auto [number, words] = leading_number(line);
  if (!(number > 0) || !std::isfinite(number)) return std::nullopt;
  if (words == "Hz" || words == "kHz") return words == "Hz" ? number : 1e3 * number;
  const auto slash = words.find('/');
  if (slash == std::string::npos) return std::nullopt;
  const auto before = unit_of(words.substr(0, slash)), after = unit_of(words.substr(slash + 1));
  if (before && !after && before->quantity == Quantity::time) return 1 / (number * before->to_si);
  if (after && !before && after->quantity == Quantity::time) return number / after->to_si;
  return std::nullopt;
}

// Returns the number in a line such as "2 channels".
std::optional<std::size_t> channels_in(std::string_view line) {
  const auto [number, word] = leading_number(line);
  const bool one_word = !word.empty() && word.find_first_of(" \t,;0123456789/") == std::string::npos;
  if (!one_word || !(number >= 1 && number <= most_channels) || number != std::floor(number))
    return std::nullopt;
  return static_cast<std::size_t>(number);
}

char delimiter_in(std::string_view line) {
  for (const char c : {'\t', ';', ','})
    if (line.find(c) != std::string_view::npos) return c;
  return '\t';
}

bool is_number(std::string_view cell, char delimiter) {
  return cell_number(cell, delimiter != ',').second == std::errc{} || clock_time(cell);
}

struct Start {
  double rate_hz;
  std::size_t channels;
  TextLines after;
};

bool is_row_of_numbers(std::string_view line) {
  const char delimiter = delimiter_in(line);
  Cells cells;
  split_cells(line, delimiter, cells);
  return cells.size() > 1 && std::all_of(cells.begin(), cells.end(),
                                         [&](std::string_view cell) { return is_number(cell, delimiter); });
}

// Returns whether the lines that follow may be names and units. In another table rows follow sooner.
bool names_follow(TextLines lines, std::size_t channels) {
  std::string_view line;
  for (std::size_t i = 0; i < 2 * channels; ++i)
    if (!lines.next_of_any_kind(line) || is_row_of_numbers(line)) return false;
  return true;
}

std::optional<Start> start_of(TextLines lines) {
  std::string_view line;
  std::optional<double> rate;
  for (std::size_t i = 0; i < farthest_rate && lines.next_of_any_kind(line); ++i) {
    if (rate)
      if (const auto channels = channels_in(line); channels && names_follow(lines, *channels))
        return Start{*rate, *channels, lines};
    rate = rate_in(line);
  }
  return std::nullopt;
}

// Returns the largest number of samples in a row of them; nothing for another row. Fewer than ten samples are
// no recording.
std::optional<double> samples_in(const Cells& cells) {
  double most = 0;
  for (const std::string_view cell : cells) {
    if (cell.empty()) continue;  // above the times
    if (cell.find_first_not_of("0123456789") != std::string_view::npos) return std::nullopt;
    const double count = cell_number(cell, false).first;
    if (!(count >= 10)) return std::nullopt;
    most = std::max(most, count);
  }
  return most > 0 ? std::optional(most) : std::nullopt;
}

class Finder {
 public:
  Finder(Start start, TableLayout& layout) : start_(std::move(start)), layout_(layout), at_(start_.after) {}

  void find() {
    layout_.header_line = at_.number();
    layout_.rate_hz = start_.rate_hz;
    std::vector<std::string> names(start_.channels), units(start_.channels);
    for (std::size_t i = 0; i < start_.channels; ++i) {
      names[i] = unquoted_line();
      units[i] = unquoted_line();
      if (names[i].empty()) names[i] = fmt::format("CH{}", i + 1);
    }
    layout_.rows = at_;
    const bool timed = read_short_names();
    layout_.names.insert(layout_.names.end(), names.begin(), names.end());
    layout_.units.insert(layout_.units.end(), units.begin(), units.end());
    compare_counts(timed);
  }

 private:
  std::string unquoted_line() {
    std::string_view line;
    at_.next_of_any_kind(line);
    Cells cells;
    split_cells(line, '\n', cells);  // one cell
    return cells.empty() ? "" : std::string(cells.front());
  }

  // Reads the row of short names, if there is one, and names a column of times. Returns whether there is one.
  bool read_short_names() {
    std::string_view line;
    if (!at_.next(line)) return false;
    layout_.delimiter = delimiter_in(line);
    Cells cells;
    split_cells(line, layout_.delimiter, cells);
    const bool is_names = std::none_of(cells.begin(), cells.end(), [&](std::string_view cell) {
      return cell.empty() || is_number(cell, layout_.delimiter);
    });
    if (is_names) layout_.rows = at_;
    if (cells.size() <= start_.channels) return false;
    const auto unit = is_names ? unit_of(cells.front()) : std::nullopt;
    layout_.names.push_back(unit ? fmt::format("horizontal axis ({})", cells.front()) : "horizontal axis");
    layout_.units.emplace_back();
    return true;
  }

  void compare_counts(bool timed) {
    TextLines at = layout_.rows;
    std::string_view line;
    Cells cells;
    if (!at.next(line)) return;
    split_cells(line, layout_.delimiter, cells);
    const auto counted = timed && !cells.empty() && !cells.front().empty() ? std::nullopt : samples_in(cells);
    if (!counted) return;
    layout_.rows = at;
    std::size_t rows = 0;
    while (at.next(line)) ++rows;
    if (static_cast<double>(rows) != *counted)
      layout_.notes.push_back(fmt::format(
          "the file counts {} samples, and {} rows follow: was its export finished?", *counted, rows));
  }

  const Start start_;
  TableLayout& layout_;
  TextLines at_;
};

}  // namespace

bool is_acqknowledge(TextLines lines) {
  return start_of(std::move(lines)).has_value();
}

TableLayout acqknowledge_layout(const TextLines& lines) {
  TableLayout layout{'\t', 0, true, {}, {}, lines, 0, {}};
  Finder(start_of(lines).value(), layout).find();
  return layout;
}

}  // namespace trunk
