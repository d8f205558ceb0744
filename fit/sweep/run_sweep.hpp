#pragma once

#include <functional>

#include "sweep/design.hpp"
#include "sweep/folder.hpp"

namespace trunk {

struct SweepOptions {
  unsigned threads = 0;  // 0: one a core
  Shard shard;
  double timeout_s = 0.0;  // for one run, of several side by side on average; 0: any
  bool retry_failed = false;
  std::string argv;  // for provenance
};

/// Of the runs of the shard.
struct SweepOutcome {
  std::size_t runs = 0;
  std::size_t found = 0;      // ended before, not simulated again
  std::size_t simulated = 0;  // now
  std::size_t failed = 0;     // of all: did not complete, or could not be set up
  bool finished = false;      // false where it was interrupted
};

/// Called as runs end with how many are done, how many there are and how many end in a second.
using SweepProgressNote = std::function<void(std::size_t done, std::size_t runs, double runs_per_s)>;

/// Does what is not done yet. Threads simulate; this one alone writes files. A run that fails is a row with
/// its error and stops no other. `cancelled()` ends the sweep after the runs under way, or at once where
/// these take long.
SweepOutcome run_sweep(const SweepDesign& design, const SweepFolder& folder, const SweepOptions& options,
                       const SweepProgressNote& note, const std::function<bool()>& cancelled);

}  // namespace trunk
