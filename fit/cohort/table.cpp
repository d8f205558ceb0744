#include "cohort/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace trunk {
namespace {

/// In quotes where it must be (RFC 4180); a text stays on its line.
std::string cell(const std::string& text) {
  if (text.find_first_of(",;\"\r\n \t") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"') result += '"';
    result += c == '\n' || c == '\r' ? ' ' : c;
  }
  return result + '"';
}

struct Cell {
  std::string name, text;
};

/// A number that is not finite is a gap.
Cell number_cell(const std::string& name, double value) {
  return {name, std::isfinite(value) ? fmt::format("{}", value) : ""};
}

void add(const RowEstimate& e, std::vector<Cell>& cells) {
  cells.push_back(number_cell(e.name, e.value));
  cells.push_back(number_cell(e.name + "_lower95", e.lower95));
  cells.push_back(number_cell(e.name + "_upper95", e.upper95));
  if (std::isfinite(e.structural_lower95)) {
    cells.push_back(number_cell(e.name + "_structural_lower95", e.structural_lower95));
    cells.push_back(number_cell(e.name + "_structural_upper95", e.structural_upper95));
  }
  if (!e.grade.empty()) cells.push_back({e.name + "_grade", e.grade});
  if (e.at_bound) cells.push_back({e.name + "_at_bound", *e.at_bound ? "1" : "0"});
}

/// Returns what a row says in numbers and grades, each with the name of its column.
std::vector<Cell> cells_of(const CohortRow& row) {
  std::vector<Cell> cells;
  for (const RowEstimate& e : row.estimates) add(e, cells);
  for (const NamedValue& v : row.numbers) cells.push_back(number_cell(v.name, v.value));
  for (const RowPrediction& p : row.predictions) {
    for (const RowEstimate& e : p.numbers) add(e, cells);
    add(p.ratio, cells);
    cells.push_back(number_cell(p.failed_draws.name, p.failed_draws.value));
  }
  return cells;
}

/// Returns the column of each name, in the order in which the names first appear.
std::map<std::string, std::size_t> columns_of(const std::vector<CohortRow>& rows,
                                              std::vector<std::string>& names) {
  std::map<std::string, std::size_t> columns;
  for (const CohortRow& row : rows)
    for (const Cell& c : cells_of(row))
      if (columns.emplace(c.name, names.size()).second) names.push_back(c.name);
  return columns;
}

}  // namespace

std::string cohort_csv(const std::vector<CohortRow>& rows) {
  std::vector<std::string> names;
  const auto columns = columns_of(rows, names);
  std::string text = "subject,status,grade,gates";
  for (const std::string& name : names) text += "," + name;
  text += ",verdict,error\n";
  for (const CohortRow& row : rows) {
    std::vector<std::string> cells(names.size());
    for (const Cell& c : cells_of(row)) cells[columns.at(c.name)] = c.text;
    text += fmt::format("{},{},{},{}", cell(row.subject), row.status, row.grade,
                        cell(fmt::format("{}", fmt::join(row.gates, " "))));
    for (const std::string& c : cells) text += "," + c;
    text += "," + cell(row.verdict) + "," + cell(row.error) + "\n";
  }
  return text;
}

}  // namespace trunk
