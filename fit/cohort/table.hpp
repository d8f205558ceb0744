#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "results/records.hpp"

namespace trunk {

/// A number in the table of a cohort that has a 95 % interval. NaN: not known.
struct RowEstimate {
  std::string name, unit;
  double value = 0.0, lower95 = 0.0, upper95 = 0.0;
  std::string grade{};             // of a result; or ""
  std::optional<bool> at_bound{};  // of a parameter that is no result; at a bound it has no interval
  double structural_lower95 = std::numeric_limits<double>::quiet_NaN();  // of a prediction
  double structural_upper95 = std::numeric_limits<double>::quiet_NaN();
};

/// A scenario that was predicted.
struct RowPrediction {
  std::vector<RowEstimate> numbers;
  RowEstimate ratio;  // of the volumes there and in the scenario of the fit
  NamedValue failed_draws;
};

/// One subject in the table of a cohort.
struct CohortRow {
  std::string subject;
  std::string status;                  // as in `fit --json`, or "failed"
  std::string grade;                   // "" if it failed
  std::vector<std::string> gates;      // names
  std::vector<RowEstimate> estimates;  // the results shown first, then parameters that are no results
  std::vector<NamedValue> numbers;     // NaN: not known
  std::vector<RowPrediction> predictions;
  std::string verdict, error;
};

/// Returns the table as CSV, one line per subject. A number that some subjects lack is a column with gaps.
/// Each number has the shortest text from which the same number is read.
std::string cohort_csv(const std::vector<CohortRow>& rows);

}  // namespace trunk
