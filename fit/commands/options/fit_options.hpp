#pragma once

#include <CLI/CLI.hpp>

#include "breaths/selection.hpp"
#include "commands/options/trace_options.hpp"
#include "subject/subject_fit.hpp"

namespace trunk {

/// What `fit` is asked for, as typed.
struct FitRequest {
  std::string scenario, trace, output, breath = "mean", save_scenario;
  std::string cohort;                // a list of subjects instead of one trace
  std::vector<std::string> predict;  // other scenarios
  int draws = 64;
  double tidal_volume_ml = 0.0;
  SignalOptions signal;
  BreathSelection selection;
  std::vector<std::string> settings, priors;
  FitPlan plan;
  std::string timing = "joint", loss = "squares", weights = "uniform";
  bool keep_timing = false;
  int surface = -1;  // not said
  bool force_profiles = false;
};

/// What may differ from subject to subject: each long name is also a column of a cohort's list.
void add_subject_options(CLI::App& command, FitRequest& request);

/// The file that the user names without an option, "SCENARIO".
void add_scenario_option(CLI::App& command, FitRequest& request);

/// Settles which files the user means: a file named without an option is a scenario if its name ends in
/// .toml, otherwise it is the trace; a fit without a scenario takes the shipped healthy.toml. Returns notes
/// that tell the user which scenario was taken. Throws InputError if two traces are named.
std::vector<std::string> settle_files(FitRequest& request);

/// The plan in full. Throws InputError on options that make no sense.
FitPlan plan_of(const FitRequest& request);

}  // namespace trunk
