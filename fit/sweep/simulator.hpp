#pragma once

#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "records/stored_subject.hpp"
#include "sweep/batch.hpp"

namespace trunk {

/// Simulates runs of a sweep. Several threads may call it.
class SweepSimulator {
 public:
  SweepSimulator(const SweepDesign& design, Provenance provenance, RunLimits limits);
  ~SweepSimulator();

  /// Returns how many runs to pass at once for the best speed. The draws of one subject fill all lanes.
  std::size_t together() const noexcept;

  /// Returns the outcomes of runs of the same model, simulated side by side if no trajectory is stored. Each
  /// outcome is the same as if the run were alone. A run that fails gives a row with its error; nothing is
  /// thrown. Runs are missing if the work was cancelled, or if several together took too long. A single run
  /// that takes too long gives a row with the status "timeout".
  std::vector<FinishedRun> operator()(std::span<const std::size_t> runs) const;

 private:
  struct Ready;  // a scenario and its trunk; only subject and parameters are still to be set

  std::shared_ptr<const Ready> ready_for(std::size_t run) const;

  const SweepDesign& design_;
  Provenance provenance_;
  RunLimits limits_;
  std::vector<StoredSubject> subjects_;
  bool subject_repeats_ = false;  // one or more of them breathe on
  mutable std::mutex mutex_;
  mutable std::shared_ptr<const Ready> last_;  // the next runs mostly have the same model
};

}  // namespace trunk
