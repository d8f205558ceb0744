#pragma once

#include "cohort/table.hpp"

namespace trunk {

/// Returns the table of a cohort for the terminal, one line per subject: the grade, the first results
/// with intervals, and the ratio that each scenario comes to. All else is in the table that is stored.
std::string cohort_table(const std::vector<CohortRow>& rows);

}  // namespace trunk
