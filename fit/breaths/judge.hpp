#pragma once

#include <vector>

#include "breaths/landmarks.hpp"
#include "breaths/segment.hpp"

namespace trunk {

/// Returns how far the rest moves over each breath, in parts of the tidal volume, beyond the median drift or
/// the drift over a neighbouring breath. A wandering base line moves neighbours alike; a shift moves one
/// breath.
std::vector<double> shifts_of(const Landmarks& marks, double drift_m3_s);

/// Judges every breath and writes its reason, in the present unit of volume; then the user's selection
/// overrules it. What is usual are medians over the breaths of the most common size (breath_sizes), or, if
/// there is one size, over all breaths with 0.3 or more of the upper quartile (our choice). `shifts`: see
/// shifts_of. => result.breaths
void judge(Segmentation& result, const std::vector<double>& shifts, const BreathSelection& selection);

/// Returns a sentence about sizes of breath and where to find them, or "" if there is one size.
std::string note_of_sizes(const Segmentation& segmentation);

}  // namespace trunk
