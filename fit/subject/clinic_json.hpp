#pragma once

#include "clinic/clinic.hpp"
#include "subject/json.hpp"
#include "verdict/fit_results.hpp"

namespace trunk {

/// Returns the numbers by name: mean over breaths with its interval, and the number of the mean breath.
Json clinic_json(const std::vector<ClinicNumber>& numbers);

/// Returns the numbers of the breath at a position in MeasuredBreath::used, by name.
Json clinic_json_of(const std::vector<ClinicNumber>& numbers, std::size_t used);

/// Returns column and unit of each channel by the name of its option; an excursion that is one number in mm.
Json channels_json(const Segmentation& segmentation);

/// Returns the numbers as results of a fit. They are determined, since they are measured; a single breath
/// shows no interval.
std::vector<FitResult> clinic_results(const std::vector<ClinicNumber>& numbers);

}  // namespace trunk
