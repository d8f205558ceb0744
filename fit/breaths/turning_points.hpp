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

/// Returns alternating maxima and minima, each at least `threshold` from the next (a zigzag with hysteresis).
/// The first and the last may be the first or last sample of the record. Fewer than two if the signal never
/// moves by `threshold`.
std::vector<TurningPoint> turning_points(std::span<const double> signal, double threshold);

/// Returns the rise from each trough to the peak after it.
std::vector<double> rises(std::span<const double> signal, const std::vector<TurningPoint>& turns);

/// Returns the turning points of breathing. The threshold is 0.3 of the median rise (our choice: a smaller
/// rise is part of the breath around it). The first thresholds tried are 0.3 of the range, then half of that
/// and so on, because a sigh or a drift may fill the range; each then follows the median rise. The largest
/// threshold is taken, unless a smaller one turns a further tenth of the record (our choice) into regular
/// cycles. Cycles longer than `longest` samples count as less regular. No unit of time or volume is used, so
/// the result can reveal a wrong unit.
std::vector<TurningPoint> breath_turning_points(std::span<const double> volume, double longest);

}  // namespace trunk
