#include "tables/labchart_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "errors/input_error.hpp"
#include "tables/clock_time.hpp"
#include "tables/column_names.hpp"
#include "tables/labchart_blocks.hpp"
#include "tables/leading_number.hpp"
#include "text/message_text.hpp"

namespace trunk {
namespace {

constexpr std::size_t rows_looked_at = 50;

using Block = LabChartBlock;
using Cells = Block::Cells;

bool is_plain_number(std::string_view cell, char delimiter) {
  return cell_number(cell, delimiter != ',').second == std::errc{};
}

bool is_date(std::string_view cell) {
  const auto marks =
      std::count_if(cell.begin(), cell.end(), [](char c) { return c == '/' || c == '.' || c == '-'; });
  return cell.size() >= 6 && cell.size() <= 10 && marks == 2 && cell.front() != '-' &&
         cell.find_first_not_of("0123456789/.-") == std::string_view::npos;
}

std::vector<Cells> first_rows(const Block& block) {
  std::vector<Cells> rows;
  TextLines at = block.rows;
  for (std::string_view line; rows.size() < rows_looked_at && at.next(line);) {
    Cells cells;
    split_cells(line, block.delimiter, cells);
    const auto comment =
        std::find_if(cells.begin(), cells.end(), [](std::string_view cell) { return cell.starts_with('#'); });
    cells.erase(comment, cells.end());
    while (!cells.empty() && cells.back().empty()) cells.pop_back();
    if (!cells.empty()) rows.push_back(std::move(cells));
  }
  return rows;
}

// Returns the step of a column of numbers that increase evenly, give or take one step, since times are
// rounded; nothing for another column.
std::optional<double> even_step(const std::vector<Cells>& rows, std::size_t column, char delimiter) {
  std::vector<double> values;
  for (const Cells& row : rows) {
    if (column >= row.size()) return std::nullopt;
    const auto [value, error] = cell_number(row[column], delimiter != ',');
    if (error != std::errc{} || !std::isfinite(value)) return std::nullopt;
    values.push_back(value);
  }
  if (values.size() < 2 || !(values.back() > values.front())) return std::nullopt;
  const double step = (values.back() - values.front()) / static_cast<double>(values.size() - 1);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (std::abs(values[i] - values.front() - step * static_cast<double>(i)) > step) return std::nullopt;
  return step;
}

// Returns the unit in which steps of a time agree with the interval; "" if there is none.
std::string unit_of_times(double step, double interval_s) {
  constexpr double tolerance = 0.05;  // times are rounded
  for (const char* unit : {"s", "ms", "min", "h"})
    if (std::abs(step * unit_of(unit)->to_si - interval_s) <= tolerance * interval_s) return unit;
  return "";
}

class Columns {
 public:
  Columns(const Block& block, TableLayout& layout)
      : block_(block), layout_(layout), rows_(first_rows(block)), titles_(block.values_of("ChannelTitle")) {
    for (const Cells& row : rows_) cells_ = std::max(cells_, row.size());
    const std::size_t ranges = block.values_of("Range").size() / (block.delimiter == ' ' ? 2 : 1);
    titles_.resize(std::max({titles_.size(), block.values_of("UnitName").size(), ranges}));
  }

  void name() {
    const bool date_first = is_date(cell(0));
    if (date_first) add("date", "");
    const bool timed = take_time(layout_.names.size());
    const std::size_t next = layout_.names.size();
    const bool too_many = cells_ > next + titles_.size() && !is_plain_number(cell(next), block_.delimiter);
    if (!date_first && (is_date(cell(next)) || too_many)) add("date", "");
    if (!timed) require_rate();
    if (titles_.empty() && cells_ > layout_.names.size()) titles_.resize(cells_ - layout_.names.size());
    for (std::size_t i = 0; i < titles_.size(); ++i)
      add(titles_[i].empty() ? fmt::format("Channel {}", i + 1) : std::string(titles_[i]),
          unit_of_channel(i));
  }

 private:
  std::string_view cell(std::size_t column) const {
    return rows_.empty() || column >= rows_.front().size() ? std::string_view{} : rows_.front()[column];
  }

  void add(std::string name, std::string unit) {
    layout_.names.push_back(std::move(name));
    layout_.units.push_back(std::move(unit));
  }

  // Finds out whether a column holds times, and names it.
  bool take_time(std::size_t column) {
    const double interval = block_.interval_s;
    if (clock_time(cell(column))) {
      add("time", "s");
      return true;
    }
    const auto step = even_step(rows_, column, block_.delimiter);
    const std::string unit = step && interval > 0 ? unit_of_times(*step, interval) : "";
    const bool by_count = cells_ > titles_.size() + column;
    if (unit.empty() && !(step && by_count)) return false;
    if (unit.empty() && interval > 0)
      layout_.notes.push_back(
          fmt::format("Interval= says {} s, and the times step by {}: the times are used, in seconds",
                      number_text(interval), number_text(*step)));
    add("time", unit.empty() ? "s" : unit);
    return true;
  }

  void require_rate() {
    layout_.rate_hz = block_.interval_s > 0 ? 1 / block_.interval_s : 0;
    if (layout_.rate_hz > 0) return;
    throw InputError({block_.rows.source(), block_.header_line},
                     "a LabChart text without times and without a known Interval=", "one of both",
                     "export it with times, or add --rate HZ");
  }

  // Returns "L/s" for the range "10.000 L/s". The range may be that of the input in V, so that a unit in the
  // name of the channel comes first.
  std::string unit_of_channel(std::size_t i) const {
    if (const Cells units = block_.values_of("UnitName"); i < units.size() && units[i] != "*")
      return std::string(units[i]);
    if (column_name(titles_[i]).quantity != Quantity::unknown) return "";
    const Cells ranges = block_.values_of("Range");
    const bool in_pairs = block_.delimiter == ' ' && ranges.size() == 2 * titles_.size();
    if (in_pairs) return std::string(ranges[2 * i + 1]);
    return i < ranges.size() ? leading_number(std::string(ranges[i])).rest : "";
  }

  const Block& block_;
  TableLayout& layout_;
  const std::vector<Cells> rows_;
  Cells titles_;
  std::size_t cells_ = 0;  // of the longest row
};

}  // namespace

TableLayout labchart_layout(const TextLines& lines, std::size_t block) {
  std::vector<std::string> notes;
  const Block chosen = labchart_block(lines, block, notes);
  TableLayout layout{chosen.delimiter, chosen.header_line, true, {}, {}, chosen.rows, 0, std::move(notes)};
  Columns(chosen, layout).name();
  return layout;
}

}  // namespace trunk
