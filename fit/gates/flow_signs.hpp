#pragma once

#include <vector>

#include "breaths/segment.hpp"

namespace trunk {

/// How abruptly flow starts and turns: medians over breaths; 0 if the samples show none.
struct FlowSigns {
  double rise_s = 0;     ///< inspiratory flow from 10 to 90 % of its peak, at the first time it is there
  double release_s = 0;  ///< from the end of inspiration (flow 0) to peak expiratory flow
  double period_s = 0;   ///< of a breath
};

/// Returns the signs of the flow of some breaths (at least one). The flow is the difference of neighbouring
/// volumes, which are samples of a spirometer or an integrated flow. It is averaged over the fewest samples
/// that leave its noise within 3 % of a breath's peak flow, and over no more than 60 ms. The peak inspiratory
/// flow is what 5 % of an inspiration exceed, so that noise on a constant flow does not make one (our
/// choice).
FlowSigns flow_signs(const Segmentation& segmentation, const std::vector<Breath>& breaths);

}  // namespace trunk
