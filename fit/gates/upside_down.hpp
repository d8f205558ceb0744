#pragma once

#include "breaths/segment.hpp"
#include "gates/flow_signs.hpp"

namespace trunk {

enum class Upright { yes, unclear, no };

/// Whether a recording is upright.
struct Orientation {
  double index = 0;           ///< above 0: more like breathing turned upside down than like breathing
  double standard_error = 0;  ///< of the index, by the spread of the breaths; 0 for a single one
  Upright upright = Upright::yes;
  FlowSigns flow;  ///< of the recording; turned, if it is upside down
};

/// Returns the orientation of a recording from some of its breaths (at least one).
///
/// Lungs fill quickly and rest empty, so s = ln(Ti/Te) + 4 (mean volume / VT - 0.5) is below 0, and turning
/// the signal changes its sign. It does so only roughly, because an onset is the end of a rest and a peak is
/// the middle of a top. Where s > -0.5, the signal is therefore turned and segmented again, and half the
/// difference of both s counts. A muscle also starts inspiration more abruptly than it lets expiration begin,
/// if it holds on: ln of the rise time of expiratory over that of inspiratory flow, within +-0.15, is
/// subtracted 0.75 times. The recording is upside down if the index is 0.16 or more and more than twice its
/// standard error. Else it is unclear if the index is above -0.1. Weights and limits are our choice: they
/// separate real recordings from themselves upside down where s does not. A pressure that shows which way is
/// up overrules the shape; a volume beside a flow settles it where the shape leaves it open.
Orientation orientation(const Segmentation& segmentation, const std::vector<Breath>& breaths);

/// Returns the kept breaths, or all if none is kept.
std::vector<Breath> breaths_to_judge(const Segmentation& segmentation);

}  // namespace trunk
