#pragma once

#include <string>

#include "breaths/segment.hpp"
#include "clinic/clinic.hpp"
#include "commands/text/output.hpp"

namespace trunk {

/// Return the breaths of a trace as one JSON object, as text and as comma-separated values: each breath, then
/// medians and totals of the kept ones. `clinic` has the numbers of the kept breaths, or is empty. Volumes
/// are in ml and ventilation is in L/min. Those of an uncalibrated belt are in its own unit, and their names
/// end in _au.
Json breaths_json(const Segmentation& segmentation, const std::vector<ClinicNumber>& clinic);
std::string breaths_text(const Segmentation& segmentation, const std::vector<ClinicNumber>& clinic);
std::string breaths_csv(const Segmentation& segmentation, const std::vector<ClinicNumber>& clinic);

/// The volume above rest, time_s and volume_ml (or volume_au), at 50 samples a second or fewer.
Json curve_json(const Segmentation& segmentation);

}  // namespace trunk
