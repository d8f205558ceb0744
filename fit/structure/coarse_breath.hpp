#pragma once

#include <optional>

#include "anatomy/breath_run.hpp"

namespace trunk {

/// Returns the recoil of a scenario's trunk, if breathing repeats. Its memory is half as long again as
/// measured, so that it serves trunks that differ in some choices: to measure each would take longer than to
/// simulate it.
std::optional<Recoil> recoil_for_choices(const Scenario& scenario);

/// A scenario with its trunk, in steps that are long enough to try many trunks.
class CoarseTrunk {
 public:
  /// `recoil` is that of a similar scenario; see recoil_for_choices. Throws InputError if the trunk is
  /// impossible.
  CoarseTrunk(const Scenario& scenario, const std::optional<Recoil>& recoil);

  /// Returns the breath with another strength of the muscle.
  BreathSummary breath(double k_muscle) const;
  /// Returns breaths with several strengths, simulated side by side.
  std::vector<BreathSummary> breaths(const std::vector<double>& k_muscle) const;

 private:
  Trunk trunk_;
  Trial<double> trial_;
  TimeGrid grid_;
};

/// How exactly muscle_for finds a tidal volume, relative (measured: it is better than this).
inline constexpr double muscle_accuracy = 1e-4;

/// Returns k_muscle, N/m, with which the trunk has this tidal volume: four strengths about the guess are
/// simulated side by side, and the strength is interpolated over the volume. NaN if there is no such breath
/// within a factor of about 4 of the guess, or if a stronger muscle does not breathe deeper.
double muscle_for(const CoarseTrunk& trunk, double tidal_volume_m3, double guess);

}  // namespace trunk
