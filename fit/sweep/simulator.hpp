#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "results/records.hpp"
#include "results/summary.hpp"
#include "sweep/design.hpp"
#include "sweep/journal.hpp"

namespace trunk {

inline constexpr double curve_step_s = 0.01;  // between the samples of a row's curve

/// What came of a run: its row, and where it is to be kept in full its record.
struct FinishedRun {
  SweepRow row;
  std::optional<RunRecord> record;
};

/// The row of a run that is on file.
SweepRow row_of(std::size_t run, const RunSummary& summary);

/// Simulates runs of a sweep. May be called from several threads.
class SweepSimulator {
 public:
  struct Limits {
    double timeout_s = 0.0;           // for one run; 0: any
    std::function<bool()> cancelled;  // asked while runs take longer than a second
  };
  SweepSimulator(const SweepDesign& design, Provenance provenance, Limits limits);
  ~SweepSimulator();

  /// How many runs are best given at once.
  std::size_t together() const noexcept;

  /// Runs of the same model, side by side where no trajectory is kept; each gives what it would alone. A run
  /// that fails is a row with its error. Never throws; where the work was cancelled, runs are missing.
  std::vector<FinishedRun> operator()(std::span<const std::size_t> runs) const;

 private:
  struct Ready;  // a scenario and its trunk: what is left to be set are subject and parameters

  std::shared_ptr<const Ready> ready_for(std::size_t run) const;

  const SweepDesign& design_;
  Provenance provenance_;
  Limits limits_;
  std::vector<std::vector<NamedValue>> subjects_;
  mutable std::mutex mutex_;
  mutable std::shared_ptr<const Ready> last_;  // runs of one model come one after the other
};

}  // namespace trunk
