#pragma once

#include <exception>
#include <functional>
#include <optional>
#include <vector>

#include "prediction/predict.hpp"
#include "results/read/stored_run.hpp"
#include "results/records.hpp"
#include "scenarios/read_scenario.hpp"
#include "sweep/design.hpp"
#include "sweep/journal.hpp"
#include "sweep/stable_range.hpp"

namespace trunk {

inline constexpr double curve_step_s = 0.01;  // time between the samples of a row's curve

/// The outcome of a run: its row, and its record if the sweep stores runs in full.
struct FinishedRun {
  SweepRow row;
  std::optional<RunRecord> record;
};

/// Returns the row of a run that is stored in a file.
SweepRow row_of(std::size_t run, const StoredRun& summary);

/// Returns the row of a run that did not complete.
SweepRow failed_row(std::size_t run, const std::string& status, const std::string& error);

/// Returns the row of a run that could not be set up. Files in its error are named relative to the design.
SweepRow invalid_row(const SweepDesign& design, std::size_t run, const std::exception& error);

/// When to give up runs.
/// Returns the seconds since some moment in the past. It never goes back.
using ClockS = std::function<double()>;
double steady_clock_s();

struct RunLimits {
  double timeout_s = 0.0;           // for one run, or on average for several side by side; 0: no limit
  std::function<bool()> cancelled;  // called while runs take longer than a second
  ClockS clock_s = steady_clock_s;  // what times are measured by; tests have their own
};

/// A run that is ready to be simulated, and what its subject may be instead.
struct PreparedRun {
  std::size_t run;
  ScenarioFile file;
  std::vector<Candidate> draws{};  // empty: its row has no intervals
};

/// Runs of one trunk. Each gives the same result, alone or side by side with others.
struct SweepBatch {
  const SweepDesign& design;
  const Provenance& provenance;
  const RunLimits& limits;
  const Trunk& trunk;
  StableRange& stable;

  /// Returns the outcomes. A run with an unstable time step fails; the others are simulated, side by side if
  /// no trajectory is stored. If several side by side take too long, they are given up and missing from the
  /// result; the caller then tries each alone. Throws Cancelled.
  std::vector<FinishedRun> simulate(std::vector<PreparedRun> runs) const;
};

}  // namespace trunk
