#pragma once

#include <string>
#include <vector>

#include "results/records.hpp"

namespace trunk {

/// One subject in the table of a cohort.
struct CohortRow {
  std::string subject;
  std::string status;  // as in `fit --json`, or "failed"
  bool identifiable = false;
  std::vector<NamedValue> numbers;  // NaN: not known
  std::string verdict, error;
};

/// One line a subject; a number that some subjects lack is a column with gaps. Numbers have the shortest text
/// that gives them back.
std::string cohort_csv(const std::vector<CohortRow>& rows);

}  // namespace trunk
