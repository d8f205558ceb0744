#pragma once

#include <functional>

#include "sweep/batch.hpp"
#include "sweep/design.hpp"
#include "sweep/folder.hpp"

namespace trunk {

/// How a sweep is run.
struct SweepOptions {
  unsigned threads = 0;  // 0: one per core
  Shard shard;
  double timeout_s = 0.0;  // for one run, or on average for several side by side; 0: no limit
  bool retry_failed = false;
  std::string argv;                 // for provenance
  ClockS clock_s = steady_clock_s;  // what timeout_s is measured by
};

/// Counts of the runs of the shard.
struct SweepOutcome {
  std::size_t runs = 0;
  std::size_t found = 0;      // had ended before, and were not simulated again
  std::size_t simulated = 0;  // were simulated now
  std::size_t failed = 0;     // of all: did not complete, or could not be set up
  bool finished = false;      // false if the sweep was interrupted
};

/// Is called as runs end.
using SweepProgressNote = std::function<void(std::size_t done, std::size_t runs, double runs_per_s)>;

/// Does the runs that are not done yet. Threads simulate, and only the calling thread writes files. A run
/// that fails gives a row with its error and stops no other run. Once `cancelled()` returns true, the sweep
/// ends after the present runs, or at once if these take longer than a second. Throws InputError if a file
/// cannot be written.
SweepOutcome run_sweep(const SweepDesign& design, const SweepFolder& folder, const SweepOptions& options,
                       const SweepProgressNote& note, const std::function<bool()>& cancelled);

}  // namespace trunk
