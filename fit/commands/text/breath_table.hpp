#pragma once

#include <string>

#include "breaths/segment.hpp"
#include "commands/text/output.hpp"

namespace trunk {

/// What segmentation made of a trace, as one JSON object, as text and as comma-separated values: each breath,
/// then medians and totals of the kept ones. Volumes in ml, ventilation in L/min; of a belt that is not
/// calibrated in its own unit, and then the names end in _au.
Json breaths_json(const Segmentation& segmentation);
std::string breaths_text(const Segmentation& segmentation);
std::string breaths_csv(const Segmentation& segmentation);

/// The volume above rest, time_s and volume_ml (or volume_au), at 50 samples a second or fewer.
Json curve_json(const Segmentation& segmentation);

}  // namespace trunk
