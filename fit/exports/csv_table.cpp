#include "exports/csv_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace trunk {

std::string unit_suffix(const std::string& unit) {
  if (unit.empty() || unit == "1") return "";
  std::string text = "_" + unit;
  for (std::size_t at; (at = text.find("-1")) != std::string::npos;) {
    text.erase(at, 2);
    const std::size_t blank = text.rfind(' ', at);
    if (blank != std::string::npos) text.insert(blank + 1, "per_");
  }
  std::replace(text.begin(), text.end(), ' ', '_');
  return text;
}

std::string csv_cell(double value) {
  return std::isnan(value) ? "" : fmt::format("{}", value);
}

std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

std::string CsvTable::csv() const {
  std::string text = header_ + "\n";
  for (const std::string& row : cells_) text += row + "\n";
  return text;
}

std::string names_and_numbers(const std::vector<NamedValue>& numbers) {
  CsvTable table;
  table.add("name", "", each(numbers, &NamedValue::name));
  table.add("value", "", each(numbers, &NamedValue::value));
  table.add("unit", "", each(numbers, &NamedValue::unit));
  return table.csv();
}

std::string series_over_time(const std::vector<double>& time_s, const std::vector<Series>& series) {
  CsvTable table;
  table.add("time", "s", time_s);
  for (const Series& s : series) table.add(s.name, s.unit, s.values);
  return table.csv();
}

std::string choices_and_shares(const Structure& s) {
  CsvTable table;
  table.add("choice", "", each(s.choices, &Structure::Choice::name));
  table.add("keys", "", each(s.choices, &Structure::Choice::keys));
  table.add("unit", "", each(s.choices, &Structure::Choice::unit));
  table.add("low", "", each(s.choices, &Structure::Choice::low));
  table.add("value", "", each(s.choices, &Structure::Choice::value));
  table.add("high", "", each(s.choices, &Structure::Choice::high));
  table.add("source", "", each(s.choices, &Structure::Choice::source));
  for (std::size_t m = 0; m < s.measures.size(); ++m) {
    const auto row = s.shares.begin() + static_cast<std::ptrdiff_t>(m * s.choices.size());
    table.add("share_" + s.measures[m], "",
              std::vector<double>(row, row + static_cast<std::ptrdiff_t>(s.choices.size())));
  }
  return table.csv();
}

}  // namespace trunk
