#pragma once

#include "subject/fit_outcome.hpp"

namespace trunk {

/// Returns what `trunk fit` prints without --json: the results and the verdict. `detailed` adds parameters,
/// activation, joint region and search.
std::string fit_table(const SubjectFit& fit, const FitOutcome& outcome, bool detailed);

}  // namespace trunk
