#pragma once

#include <CLI/CLI.hpp>

#include "commands/text/output.hpp"
#include "subject/fit_request.hpp"

namespace trunk {

/// Carries out `trunk fit --cohort` and prints its table. `typed` are the options given to all subjects.
Exit fit_cohort(const Common& common, FitRequest request, const std::string& typed);

/// Returns the options, as typed, on which a subject's result depends.
std::string subject_options_text(const CLI::App& command);

}  // namespace trunk
