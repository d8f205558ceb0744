#pragma once

#include "breaths/selection.hpp"
#include "clinic/clinic.hpp"
#include "subject/subject_fit.hpp"
#include "traces/read_signal.hpp"

namespace trunk {

/// What a user asks of a fit, as typed: the names of files, and values that plan_of turns into a plan.
struct FitRequest {
  std::string scenario, trace, output, breath = "mean", save_scenario;
  std::string cohort;                // file that lists the subjects; empty: one trace is fitted
  std::vector<std::string> predict;  // files of other scenarios
  int draws = 64;
  bool structural = true;        // predictions have structural intervals
  double tidal_volume_ml = 0.0;  // 0: not given
  SignalOptions signal;
  BreathSelection selection;
  ClinicOptions clinic;
  std::vector<std::string> settings, priors;  // key=value; see prior_of
  FitPlan plan;
  std::string timing = "joint", assume, loss = "squares", weights = "uniform";
  bool keep_timing = false;
  int surface = -1;  // points along each parameter; -1: not given
};

/// Returns what is known beforehand of a parameter: name=MEAN:FACTOR (name=MEAN:SD for a parameter that is
/// searched for by amounts), name=:FACTOR around the start, or name=none. Throws InputError if the text is
/// none of these, if there is no such parameter, or if the deviation is out of bounds.
Prior prior_of(const std::string& text);

/// Returns the plan in full. Throws InputError on options that contradict each other.
FitPlan plan_of(const FitRequest& request);

}  // namespace trunk
