#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace trunk {

/// A place where a signal turns by more than noise.
struct TurningPoint {
  std::size_t index;  ///< sample
  bool peak;          ///< a maximum; else a trough
};

/// Alternating maxima and minima, each at least `threshold` from the next (a zigzag with hysteresis). The
/// first and the last are extremes towards the ends of the record and may be its very first or last sample.
/// Fewer than two when the signal never moves by `threshold`.
std::vector<TurningPoint> turning_points(std::span<const double> signal, double threshold);

/// From each trough to the peak after it.
std::vector<double> rises(std::span<const double> signal, const std::vector<TurningPoint>& turns);

/// Turning points of breathing, the threshold at 0.3 of the median rise (our choice: a rise of under a third
/// of a tidal volume is a wiggle of the breath around it). The scale comes from the signal: from 0.3 of the
/// range, which a sigh or a drift may fill, first thresholds are halved and each follows the median rise;
/// taken is the largest for which hardly more of the record (a tenth, our choice) would be regular cycles
/// with a smaller one. Knows no unit of time or volume, so that wrong units can be told from what it finds.
std::vector<TurningPoint> breath_turning_points(std::span<const double> volume, double longest);

}  // namespace trunk
