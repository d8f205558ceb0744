#pragma once

#include <optional>
#include <vector>

#include "breaths/mean_breath.hpp"

namespace trunk {

/// What the heart adds to a pressure.
struct Heartbeat {
  double period_s = 0;
  double deviation = 0;  ///< standard deviation of what it adds, Pa
};

/// Returns the heartbeat in a signal: what is left of it after its own breaths' mean and slow changes (a
/// moving average over 1.5 s) are removed repeats after 0.4 to 1.5 s, with an autocorrelation above 0.3, and
/// again after twice that time (our choice). Returns nothing if it does not.
std::optional<Heartbeat> heartbeat(const Segmentation& segmentation, const std::vector<double>& signal,
                                   const MeasuredChannel& channel, const MeasuredBreath& mean);

}  // namespace trunk
