#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace trunk {

/// A part of a flow that reads zero while air flows, because the flowmeter zeroes itself.
struct ZeroPulse {
  std::size_t first, last;  ///< samples, both included
};

/// Returns the pulses of a flow. It is near zero (within 0.4 % of its central range) for 0.1 to 1 s, and
/// jumps there and back on the same side of zero. A pulse from 0.03 s on, or one during which the direction
/// of flow changes, as in a held breath of a ventilator, must be as long as two or more on the same side (our
/// choice).
std::vector<ZeroPulse> zero_pulses(std::span<const double> time_s, std::span<const double> flow);

/// Replaces each pulse by a cubic that goes on as the flow before and after it. => flow
void bridge(std::span<const double> time_s, const std::vector<ZeroPulse>& pulses, std::vector<double>& flow);

}  // namespace trunk
