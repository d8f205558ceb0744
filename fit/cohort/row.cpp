#include "cohort/row.hpp"

#include <algorithm>
#include <cmath>

namespace trunk {
namespace {

RowEstimate row_estimate(const std::string& name, const Estimate& e) {
  const double unknown = std::nan("");
  return {name, e.unit,    e.value, e.at_bound ? unknown : e.lower95, e.at_bound ? unknown : e.upper95,
          "",   e.at_bound};
}

/// Returns the columns of a prediction.
RowPrediction row_prediction(const PredictionSummary& p) {
  RowPrediction row{{}, {}, {p.name + "_failed_draws", "1", static_cast<double>(p.failed)}};
  for (const Predicted& n : p.numbers) {
    const bool ratio = n.name == "ratio_percent";
    RowEstimate e{p.name + (ratio ? "_percent" : "_" + n.name), n.unit, n.value, n.lower95, n.upper95};
    e.structural_lower95 = n.structural_lower95;
    e.structural_upper95 = n.structural_upper95;
    if (ratio)
      row.ratio = std::move(e);
    else
      row.numbers.push_back(std::move(e));
  }
  return row;
}

RowEstimate row_estimate(const FitResult& r) {
  return {r.name, r.unit, r.value, r.lower95, r.upper95, std::string(name_of(r.grade))};
}

bool among(const std::vector<FitResult>& results, const std::string& name) {
  return std::any_of(results.begin(), results.end(), [&](const FitResult& r) { return r.name == name; });
}

}  // namespace

CohortRow cohort_row(const std::string& subject, const FitSummary& fit) {
  CohortRow row;
  row.subject = subject;
  row.status = fit.status;
  row.grade = name_of(fit.grade);
  row.gates = fit.gates;
  row.verdict = fit.verdict;
  for (const std::string& name : fit.headline)
    for (const FitResult& r : fit.results)
      if (r.name == name) row.estimates.push_back(row_estimate(r));
  for (const Estimate& e : fit.parameters)
    if (!among(fit.results, e.name)) row.estimates.push_back(row_estimate(e.name, e));
  if (fit.ratio && !among(fit.results, "k_muscle_over_k_elasticity"))
    row.estimates.push_back(row_estimate("ratio", *fit.ratio));
  row.numbers = {{"nrmse_percent", "percent", fit.nrmse_percent},
                 {"baseline_nrmse_percent", "percent", fit.baseline_nrmse_percent},
                 {"tidal_volume_measured_ml", "ml", fit.tidal_volume_measured_ml},
                 {"breaths_used", "1", static_cast<double>(fit.breaths_used)},
                 {"breaths_rejected", "1", static_cast<double>(fit.breaths_rejected)}};
  for (const PredictionSummary& p : fit.predictions) row.predictions.push_back(row_prediction(p));
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
