#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "problem/trunk_model.hpp"
#include "structure/choices.hpp"

namespace trunk {

/// A trunk to try: choices at places of their ranges; all others are the scenario's own.
struct Placed {
  std::vector<std::pair<const Choice*, double>> choices;
  double muscle_guess = 0.0;  // N/m, where the refit begins
};

/// What came of it.
struct Tried {
  double k_muscle = 0.0;                     // N/m, refitted
  std::vector<std::vector<double>> numbers;  // [other scenarios] measures, own_delta_v_ml, ratio_percent
  std::string error;                         // why there are no numbers; or ""
};

/// Tries trunks that all have the tidal volume of the subject, in coarse steps.
class Trials {
 public:
  /// `own` is the scenario in which the tidal volume was measured. Both must outlive the trials.
  Trials(const Scenario& own, const std::vector<Scenario>& others);

  /// Returns the trunk with no choice changed.
  const Tried& unchanged() const noexcept { return unchanged_; }

  /// Tries trunks side by side; the first ones begin first. Throws Cancelled.
  std::vector<Tried> tried(const std::vector<Placed>& all, const Execution& execution) const;

 private:
  Tried one(const Placed& placed) const;
  double refitted_muscle(const Placed& placed) const;

  const Scenario& own_;
  const std::vector<Scenario>& others_;
  std::optional<Recoil> own_recoil_;
  std::vector<std::optional<Recoil>> recoils_;  // [others]
  double tidal_volume_m3_ = 0.0;
  Tried unchanged_;
};

}  // namespace trunk
