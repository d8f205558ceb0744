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

/// Names in the order in which they first appear, each with its column.
std::map<std::string, std::size_t> columns_of(const std::vector<CohortRow>& rows,
                                              std::vector<std::string>& names) {
  std::map<std::string, std::size_t> columns;
  for (const CohortRow& row : rows)
    for (const NamedValue& v : row.numbers)
      if (columns.emplace(v.name, names.size()).second) names.push_back(v.name);
  return columns;
}

}  // namespace

std::string cohort_csv(const std::vector<CohortRow>& rows) {
  std::vector<std::string> names;
  const auto columns = columns_of(rows, names);
  std::string text = "subject,status,identifiable";
  for (const std::string& name : names) text += "," + name;
  text += ",verdict,error\n";
  for (const CohortRow& row : rows) {
    std::vector<double> values(names.size(), std::nan(""));
    for (const NamedValue& v : row.numbers) values[columns.at(v.name)] = v.value;
    text += fmt::format("{},{},{}", cell(row.subject), row.status, row.identifiable ? "yes" : "no");
    for (const double v : values) text += std::isfinite(v) ? fmt::format(",{}", v) : ",";
    text += "," + cell(row.verdict) + "," + cell(row.error) + "\n";
  }
  return text;
}

}  // namespace trunk
