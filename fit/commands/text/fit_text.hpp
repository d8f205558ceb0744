#pragma once

#include "commands/fit_job.hpp"

namespace trunk {

/// What `fit --json` says of an estimation; see README for the keys.
Json fit_json(const SubjectFit& fit, const FitOutcome& outcome);

/// The same as a table.
std::string fit_table(const SubjectFit& fit, const FitOutcome& outcome);

/// value, unit, interval of an estimate.
Json interval_json(const Estimate& e);

}  // namespace trunk
