#pragma once

#include "subject/fit_outcome.hpp"

namespace trunk {

/// Returns what `trunk fit` prints without --json.
std::string fit_table(const SubjectFit& fit, const FitOutcome& outcome);

}  // namespace trunk
