#pragma once

#include <exception>
#include <functional>
#include <optional>
#include <vector>

#include "results/read/stored_run.hpp"
#include "results/records.hpp"
#include "scenarios/read_scenario.hpp"
#include "sweep/design.hpp"
#include "sweep/journal.hpp"
#include "sweep/stable_range.hpp"

namespace trunk {

inline constexpr double curve_step_s = 0.01;  // between the samples of a row's curve

/// What came of a run: its row, and where it is to be kept in full its record.
struct FinishedRun {
  SweepRow row;
  std::optional<RunRecord> record;
};

/// The row of a run that is on file.
SweepRow row_of(std::size_t run, const StoredRun& summary);

/// The row of a run that did not end.
SweepRow failed_row(std::size_t run, const std::string& status, const std::string& error);

/// The row of a run that could not be set up.
SweepRow invalid_row(const SweepDesign& design, std::size_t run, const std::exception& error);

struct RunLimits {
  double timeout_s = 0.0;           // for one run, of several side by side on average; 0: any
  std::function<bool()> cancelled;  // asked while runs take longer than a second
};

/// A run, ready to be simulated.
struct PreparedRun {
  std::size_t run;
  ScenarioFile file;
};

/// Runs of one trunk. How they are simulated does not show in what comes of each.
struct SweepBatch {
  const SweepDesign& design;
  const Provenance& provenance;
  const RunLimits& limits;
  const Trunk& trunk;
  StableRange& stable;

  /// Fails what is unstable and simulates the others, side by side where no trajectory is kept. Several that
  /// together take longer than they may are given up and missing: each is to be tried by itself. Throws
  /// Cancelled.
  std::vector<FinishedRun> simulate(std::vector<PreparedRun> runs) const;
};

}  // namespace trunk
