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

void add(const RowEstimate& e, std::vector<NamedValue>& cells) {
  cells.push_back({e.name, e.unit, e.value});
  cells.push_back({e.name + "_lower95", e.unit, e.lower95});
  cells.push_back({e.name + "_upper95", e.unit, e.upper95});
  cells.push_back({e.name + "_at_bound", "1", e.at_bound ? 1.0 : 0.0});
}

/// Returns all numbers of a row, each with the name of its column.
std::vector<NamedValue> cells_of(const CohortRow& row) {
  std::vector<NamedValue> cells;
  for (const RowEstimate& e : row.estimates) add(e, cells);
  cells.insert(cells.end(), row.numbers.begin(), row.numbers.end());
  for (const RowPrediction& p : row.predictions) {
    add(p.delta_v, cells);
    add(p.ratio, cells);
    cells.push_back(p.failed_draws);
  }
  return cells;
}

/// Returns the column of each name, in the order in which the names first appear.
std::map<std::string, std::size_t> columns_of(const std::vector<CohortRow>& rows,
                                              std::vector<std::string>& names) {
  std::map<std::string, std::size_t> columns;
  for (const CohortRow& row : rows)
    for (const NamedValue& v : cells_of(row))
      if (columns.emplace(v.name, names.size()).second) names.push_back(v.name);
  return columns;
}

}  // namespace

std::string cohort_csv(const std::vector<CohortRow>& rows) {
  std::vector<std::string> names;
  const auto columns = columns_of(rows, names);
  std::string text = "subject,status,grade";
  for (const std::string& name : names) text += "," + name;
  text += ",verdict,error\n";
  for (const CohortRow& row : rows) {
    std::vector<double> values(names.size(), std::nan(""));
    for (const NamedValue& v : cells_of(row)) values[columns.at(v.name)] = v.value;
    text += fmt::format("{},{},{}", cell(row.subject), row.status, name_of(row.grade));
    for (const double v : values) text += std::isfinite(v) ? fmt::format(",{}", v) : ",";
    text += "," + cell(row.verdict) + "," + cell(row.error) + "\n";
  }
  return text;
}

}  // namespace trunk
