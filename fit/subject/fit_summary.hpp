#pragma once

#include "subject/fit_outcome.hpp"
#include "subject/json.hpp"

namespace trunk {

/// A prediction without its draws.
struct PredictionSummary {
  std::string name;                // the scenario's file without folder and ending
  std::string scenario;            // its file
  std::vector<Predicted> numbers;  // see Prediction
  std::size_t draws = 0;
  int failed = 0;         // draws of which one of the two simulations did not complete
  Structure structure{};  // of the structural intervals; or empty

  /// Returns the number of that name, which must be there.
  const Predicted& operator[](std::string_view number) const;
};

/// What a cohort's table and its JSON hold of the fit of one subject, in the units that users see.
struct FitSummary {
  std::string status;  // "converged", "not_identifiable" or "not_converged"
  Grade grade = Grade::not_converged;
  std::vector<std::string> gates;  // names
  std::vector<FitResult> results;
  std::vector<std::string> headline;  // names of results
  std::vector<Estimate> parameters;   // those asked for; empty if the search found nothing to stand on
  std::optional<Estimate> ratio;      // k_muscle / k_elasticity; none if neither is free
  double nrmse_percent = 0.0, baseline_nrmse_percent = 0.0, tidal_volume_measured_ml = 0.0;
  int breaths_used = 0, breaths_rejected = 0;
  std::optional<double> median_latency_ms;  // none unless each breath was fitted
  std::vector<PredictionSummary> predictions;
  std::string verdict;
  std::size_t simulated = 0;
};

PredictionSummary summary_of(const Prediction& prediction);
FitSummary summary_of(const SubjectFit& fit, const FitOutcome& outcome);

/// Returns value, unit, standard error, intervals and verdict of an estimate.
Json to_json(const Estimate& estimate);
Json to_json(const FitResult& result);
Json to_json(const FitSummary& summary);

/// Returns what to_json wrote; numbers that were not finite are NaN. Throws nlohmann::json::exception if a
/// key is absent or has another type. Keys of which a summary knows nothing are passed over.
FitSummary summary_from_json(const Json& json);

}  // namespace trunk
