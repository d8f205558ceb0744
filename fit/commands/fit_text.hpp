#pragma once

#include "commands/output.hpp"
#include "subject/subject_fit.hpp"

namespace trunk {

/// What `fit --json` says of an estimation; see README for the keys.
Json fit_json(const SubjectFit& fit, const Estimation& e, std::size_t replayed, double wall_s);

/// The same as a table.
std::string fit_table(const SubjectFit& fit, const Estimation& e, std::size_t replayed);

/// value, unit, interval of an estimate.
Json interval_json(const Estimate& e);

}  // namespace trunk
