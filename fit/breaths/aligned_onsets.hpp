#pragma once

#include <vector>

#include "breaths/turn_windows.hpp"

namespace trunk {

/// One breath, as far as it is known.
struct RoughBreath {
  double onset_s, peak_s, tidal_volume;
};

/// Returns the onsets of breaths in a volume whose noise is a walk. One onset shows in few samples only, so
/// that noise moves it. All breaths together show a mean inspiration, and each onset is moved to where that
/// fits the whole inspiration best: its steps, stretched between onset and peak, in the size of the breath.
/// Then all move by as much as the mean inspiration, which has little noise, shows. A breath of unusual size
/// keeps its onset; so do all if there are less than five (our choice).
std::vector<double> aligned_onsets(const BinnedVolume& level, const std::vector<RoughBreath>& breaths);

}  // namespace trunk
