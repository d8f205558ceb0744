#pragma once

#include "commands/options/fit_options.hpp"
#include "commands/text/output.hpp"

namespace trunk {

/// Fits every subject of the list, side by side; one that fails is a row and stops no other. Subjects whose
/// fit is there already, made from the same files and options, are not fitted again. `typed` are the options
/// given to all.
Exit fit_cohort(const Common& common, FitRequest request, const std::string& typed);

/// What was typed of the options that a subject's result depends on.
std::string subject_options_text(const CLI::App& command);

}  // namespace trunk
