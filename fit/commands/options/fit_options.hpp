#pragma once

#include <CLI/CLI.hpp>

#include "subject/fit_request.hpp"

namespace trunk {

/// Adds the options that may differ from subject to subject: each long name is also a column of a cohort's
/// list.
void add_subject_options(CLI::App& command, FitRequest& request);

/// Adds SCENARIO, the file that the user names without an option.
void add_scenario_option(CLI::App& command, FitRequest& request);

/// Settles which files the user means: a file named without an option is a scenario if its name ends in
/// .toml, otherwise it is the trace; a fit without a scenario takes the shipped healthy.toml. Returns notes
/// that tell the user which scenario was taken. Throws InputError if two traces are named.
std::vector<std::string> settle_files(FitRequest& request);

}  // namespace trunk
