#pragma once

#include <vector>

#include "breaths/segment.hpp"

namespace trunk {

/// How abruptly flow starts and turns; 0 if noise or few samples hide it.
struct FlowSigns {
  double rise_s = 0;    ///< inspiratory flow from 10 to 90 % of its peak, the first time it is there
  double fall_s = 0;    ///< expiratory flow from 10 to 90 % of its peak
  double period_s = 0;  ///< of a breath, median
};

/// Returns the signs of the flow of some breaths (at least one). The flow is the mean over up to 60 breaths,
/// aligned at their onsets, or at their peaks, and divided by their tidal volumes: the difference of the
/// volumes half a width before and after, at least one sample apart. The width is the least, up to 150 ms, at
/// which the mean's standard error is within 3 % of the peak flow; if it exceeds 6 %, or with fewer than 10
/// samples a second, nothing is seen. What a width adds to a rise is removed, down to half the width (all our
/// choice).
FlowSigns flow_signs(const Segmentation& segmentation, const std::vector<Breath>& breaths);

}  // namespace trunk
