#pragma once

#include "clinic/clinic.hpp"
#include "prediction/predict.hpp"
#include "results/records.hpp"
#include "subject/each_breath.hpp"

namespace trunk {

/// A scenario's file without folder and ending: what a prediction is called.
std::string short_name(const std::string& scenario);

/// Returns the median latency, s; NaN if there are no breaths.
double median_latency_s(const std::vector<BreathRefit>& breaths);

/// => the searches of one compartment
void add_starts(const SubjectFit& fit, FitRecord& record);
/// => grade, gates, results, straight lines, verdict
void add_results(const FitResults& results, FitRecord& record);
void add_breaths(const std::vector<BreathRefit>& breaths, FitRecord& record);
/// Adds the numbers of a clinic to the breaths that a fit used. A breath that it did not use has none.
void add_clinic(const MeasuredBreath& breath, const std::vector<ClinicNumber>& numbers, FitRecord& record);
void add_predictions(const std::vector<Prediction>& predictions, FitRecord& record);

}  // namespace trunk
