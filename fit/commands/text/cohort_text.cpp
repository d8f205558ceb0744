#include "commands/text/cohort_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "commands/text/output.hpp"

namespace trunk {
namespace {

std::vector<RowEstimate> shown_of(const CohortRow& row) {
  std::vector<RowEstimate> all = row.estimates;
  for (const RowPrediction& p : row.predictions) all.push_back(p.ratio);
  return all;
}

/// "4013 (3800 to 4240)"
std::string interval_text(const CohortRow& row, const std::string& name) {
  for (const RowEstimate& e : shown_of(row)) {
    if (e.name != name || !std::isfinite(e.value)) continue;
    if (e.at_bound) return fmt::format("{:.4g} (AT BOUND)", e.value);
    return fmt::format("{:.4g} ({} to {})", e.value, shown(e.lower95, "{:.4g}"), shown(e.upper95, "{:.4g}"));
  }
  return "-";
}

}  // namespace

std::string cohort_table(const std::vector<CohortRow>& rows) {
  std::size_t width = 7;
  std::vector<std::string> names;  // of all subjects, in the order in which they first appear
  for (const CohortRow& row : rows) {
    width = std::max(width, row.subject.size());
    for (const RowEstimate& e : shown_of(row))
      if (std::find(names.begin(), names.end(), e.name) == names.end()) names.push_back(e.name);
  }
  std::string text = fmt::format("  {:<{}}  {:<16}", "subject", width, "status");
  for (const std::string& name : names) text += fmt::format("  {:<32}", name);
  for (const CohortRow& row : rows) {
    text += fmt::format("\n  {:<{}}  {:<16}", row.subject, width, row.status);
    if (row.status == "failed")
      text += "  " + row.error;
    else
      for (const std::string& name : names) text += fmt::format("  {:<32}", interval_text(row, name));
  }
  return text;
}

}  // namespace trunk
