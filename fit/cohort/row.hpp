#pragma once

#include "cohort/table.hpp"
#include "subject/fit_summary.hpp"

namespace trunk {

/// Returns the row of a subject that was fitted.
CohortRow cohort_row(const std::string& subject, const FitSummary& fit);

/// Returns the row of a subject that could not be fitted; `error` says why.
CohortRow failed_row(const std::string& subject, const std::string& error);

}  // namespace trunk
