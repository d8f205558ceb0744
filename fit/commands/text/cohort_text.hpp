#pragma once

#include "cohort/table.hpp"

namespace trunk {

/// Returns the table of a cohort for the terminal, one line per subject: parameters, their ratio, and the
/// ratio that each scenario comes to, with intervals.
std::string cohort_table(const std::vector<CohortRow>& rows);

}  // namespace trunk
