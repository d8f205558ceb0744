#pragma once

#include <functional>

#include "anatomy/breath_run.hpp"
#include "problem/measured_curve.hpp"
#include "problem/volume_model.hpp"

namespace trunk {

/// How simulations are run.
struct Execution {
  unsigned threads = 0;  // 0: one per core
  std::function<bool()> cancelled;
  std::function<void(std::size_t)> progress;  // called with the number of simulations so far
};

/// The trunk as a model of what was measured. Several candidates are simulated side by side. A simulation
/// that is in the ledger is not run again.
class TrunkModel final : public VolumeModel {
 public:
  /// All arguments must outlive the model.
  TrunkModel(const Trunk& trunk, const TimeGrid& grid, const MeasuredCurve& measured, Ledger& ledger,
             const Execution& execution = {});

  /// Throws Cancelled once the execution is cancelled.
  std::vector<LedgerEntry> at(const std::vector<Candidate>& candidates) override;
  std::optional<LedgerEntry> slopes(const Candidate& candidate,
                                    const std::vector<Candidate>& directions) override;
  bool is_simulation() const noexcept override { return true; }

  std::size_t simulated() const noexcept { return simulated_; }  // without those found in the ledger
  const TimeGrid& grid() const noexcept { return grid_; }

 private:
  bool usable(const LedgerEntry* entry, std::size_t numbers) const;
  void simulate_missing(const std::vector<Candidate>& candidates, const std::vector<std::string>& keys);
  std::vector<LedgerEntry> simulate(const std::vector<Candidate>& candidates) const;
  LedgerEntry simulate_slopes(const Candidate& candidate, const std::vector<Candidate>& directions) const;
  Eigen::VectorXd observed(const Candidate& candidate, const BreathCurves& curves, double dt_s) const;
  Eigen::VectorXd observed(const Candidate& candidate, const BreathCurves& curves, const Candidate& direction,
                           const BreathCurves& derivatives, double dt_s) const;
  void count(std::size_t simulations);

  const Trunk& trunk_;
  const TimeGrid& grid_;
  const MeasuredCurve& curve_;
  std::size_t values_;  // measured
  Ledger& ledger_;
  Execution execution_;
  std::size_t simulated_ = 0;
};

/// Returns the key of a simulation in the ledger: parameters and activation as bytes.
std::string ledger_key(const Candidate& candidate);

}  // namespace trunk
