#pragma once

#include <optional>
#include <vector>

#include "ledger/ledger.hpp"
#include "problem/free_parameters.hpp"

namespace trunk {

/// A model of what is measured of one breath: the lung volume at the samples, then what is beside it. There
/// are two: the trunk itself, and one compartment that stands in for it while a fit looks around.
class VolumeModel {
 public:
  virtual ~VolumeModel() = default;

  /// Returns what each candidate gives, [candidates]. An entry without values is a simulation that failed.
  virtual std::vector<LedgerEntry> at(const std::vector<Candidate>& candidates) = 0;

  /// Returns the exact derivatives of the samples along directions, one direction after the other; none if
  /// the model has no exact derivatives. An entry without values is a simulation that failed.
  virtual std::optional<LedgerEntry> slopes(const Candidate& candidate,
                                            const std::vector<Candidate>& directions) = 0;

  /// Returns whether a fit reports each evaluation.
  virtual bool is_simulation() const noexcept = 0;
};

}  // namespace trunk
