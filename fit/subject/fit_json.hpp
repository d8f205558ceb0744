#pragma once

#include "subject/fit_outcome.hpp"
#include "subject/json.hpp"

namespace trunk {

/// Returns what `trunk fit --json` prints: the summary of the fit and all details that are numbers or texts.
Json fit_json(const SubjectFit& fit, const FitOutcome& outcome);

}  // namespace trunk
