#include "commands/text/cohort_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "commands/text/result_text.hpp"

namespace trunk {
namespace {

constexpr std::size_t most_estimates = 3;

std::vector<RowEstimate> shown_of(const CohortRow& row) {
  std::vector<RowEstimate> all = row.estimates;
  all.resize(std::min(all.size(), most_estimates));
  for (const RowPrediction& p : row.predictions) all.push_back(p.ratio);
  return all;
}

/// "0.50 (0.20 to 1.70)"
std::string cell_text(const CohortRow& row, const std::string& name) {
  for (const RowEstimate& e : shown_of(row)) {
    if (e.name != name) continue;
    if (e.at_bound && *e.at_bound) return fmt::format("{:.4g} (AT BOUND)", e.value);
    if (!std::isfinite(e.value)) return e.grade.empty() ? "not known" : "withheld";
    return interval_text({e.name, "1", e.value, e.lower95, e.upper95});
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
  std::string text = fmt::format("  {:<{}}  {:<16}  {:<16}", "subject", width, "status", "grade");
  for (const std::string& name : names) text += fmt::format("  {:<32}", name);
  for (const CohortRow& row : rows) {
    text += fmt::format("\n  {:<{}}  {:<16}  {:<16}", row.subject, width, row.status, row.grade);
    if (row.status == "failed")
      text += "  " + row.error;
    else
      for (const std::string& name : names) text += fmt::format("  {:<32}", cell_text(row, name));
  }
  return text;
}

}  // namespace trunk
