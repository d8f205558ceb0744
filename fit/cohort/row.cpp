#include "cohort/row.hpp"

#include <cmath>

namespace trunk {
namespace {

RowEstimate row_estimate(const std::string& name, const Estimate& e) {
  const double unknown = std::nan("");
  return {name,      e.unit, e.value, e.at_bound ? unknown : e.lower95, e.at_bound ? unknown : e.upper95,
          e.at_bound};
}

RowEstimate row_estimate(const std::string& name, const std::string& unit, const Predicted& p) {
  return {name, unit, p.value, p.lower95, p.upper95, false};
}

}  // namespace

CohortRow cohort_row(const std::string& subject, const FitSummary& fit) {
  CohortRow row;
  row.subject = subject;
  row.status = fit.status;
  row.grade = fit.grade;
  row.verdict = fit.verdict;
  for (const Estimate& e : fit.parameters) row.estimates.push_back(row_estimate(e.name, e));
  if (fit.ratio) row.estimates.push_back(row_estimate("ratio", *fit.ratio));
  row.numbers = {{"nrmse_percent", "percent", fit.nrmse_percent},
                 {"baseline_nrmse_percent", "percent", fit.baseline_nrmse_percent},
                 {"tidal_volume_measured_ml", "ml", fit.tidal_volume_measured_ml},
                 {"breaths_used", "1", static_cast<double>(fit.breaths_used)},
                 {"breaths_rejected", "1", static_cast<double>(fit.breaths_rejected)}};
  for (const PredictionSummary& p : fit.predictions)
    row.predictions.push_back({row_estimate(p.name + "_delta_v_ml", "ml", p.delta_v_ml),
                               row_estimate(p.name + "_percent", "percent", p.ratio_percent),
                               {p.name + "_failed_draws", "1", static_cast<double>(p.failed)}});
  return row;
}

CohortRow failed_row(const std::string& subject, const std::string& error) {
  CohortRow row;
  row.subject = subject;
  row.status = "failed";
  row.error = error;
  return row;
}

}  // namespace trunk
