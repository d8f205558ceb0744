#pragma once

#include "verdict/fit_results.hpp"

#include <string>
#include <vector>

#include "results/records.hpp"

namespace trunk {

/// A number in the table of a cohort that has a 95 % interval. NaN: not known.
struct RowEstimate {
  std::string name, unit;
  double value = 0.0, lower95 = 0.0, upper95 = 0.0;
  bool at_bound = false;  // then it has no interval: a linear model has none at a bound
};

/// A scenario that was predicted.
struct RowPrediction {
  RowEstimate delta_v, ratio;
  NamedValue failed_draws;
};

/// One subject in the table of a cohort.
struct CohortRow {
  std::string subject;
  std::string status;  // as in `fit --json`, or "failed"
  Grade grade = Grade::not_converged;
  std::vector<RowEstimate> estimates;  // parameters and their ratio
  std::vector<NamedValue> numbers;     // NaN: not known
  std::vector<RowPrediction> predictions;
  std::string verdict, error;
};

/// Returns the table as CSV, one line per subject. A number that some subjects lack is a column with gaps.
/// Each number has the shortest text from which the same number is read.
std::string cohort_csv(const std::vector<CohortRow>& rows);

}  // namespace trunk
