#pragma once

#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "sweep/batch.hpp"

namespace trunk {

/// Simulates runs of a sweep. May be called from several threads.
class SweepSimulator {
 public:
  SweepSimulator(const SweepDesign& design, Provenance provenance, RunLimits limits);
  ~SweepSimulator();

  /// How many runs are best given at once.
  std::size_t together() const noexcept;

  /// Runs of the same model, side by side where no trajectory is kept; each gives what it would alone. A run
  /// that fails is a row with its error. Never throws; where the work was cancelled, runs are missing, and
  /// so are several that took too long together: one alone is then a row that timed out.
  std::vector<FinishedRun> operator()(std::span<const std::size_t> runs) const;

 private:
  struct Ready;  // a scenario and its trunk: what is left to be set are subject and parameters

  std::shared_ptr<const Ready> ready_for(std::size_t run) const;

  const SweepDesign& design_;
  Provenance provenance_;
  RunLimits limits_;
  std::vector<std::vector<NamedValue>> subjects_;
  mutable std::mutex mutex_;
  mutable std::shared_ptr<const Ready> last_;  // runs of one model come one after the other
};

}  // namespace trunk
