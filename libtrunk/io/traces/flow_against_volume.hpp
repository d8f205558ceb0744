#pragma once

#include <vector>

namespace trunk {

/// How a flow goes with a volume of the same recording.
struct FlowAgainstVolume {
  bool seen = false;  ///< both change over at least 20 steps; else nothing below counts
  double along = 0;   ///< correlation of the flow with the rise of the volume; -1: one of them is upside down
  double best = 0;    ///< the correlation that is farthest from 0 if the volume may be late or early
  double lag_s = 0;   ///< by which the volume is late there
  double gain = 0;    ///< rise of the volume over the flow's integral there, without its sign
};

/// Compares a flow with a volume over steps of 0.1 s. For correlations neither needs a unit, and steps are
/// limited to three times their median size, so that resets of the volume hardly count. The volume may be
/// late or early by up to 0.6 s; where the correlation without a lag is beyond +-0.5, only lags of the same
/// sign count. The gain is a median over steps of the same direction with a flow of at least 0.3 of its 90th
/// percentile. All our choice.
FlowAgainstVolume flow_against_volume(const std::vector<double>& time_s, const std::vector<double>& flow,
                                      const std::vector<double>& volume);

}  // namespace trunk
