#pragma once

#include "estimation/estimate.hpp"
#include "results/records.hpp"
#include "scenarios/read_scenario.hpp"

namespace trunk {

/// Returns how well the fitted curve meets the measured one: errors, information criteria and the objective,
/// by the names that files and `fit --json` give them.
std::vector<NamedValue> quality_numbers(const Estimation& estimation);

/// Returns the noise of the trace and what it makes of the intervals, named as above.
std::vector<NamedValue> noise_numbers(const Uncertainty& uncertainty);

/// Returns the record of a fit. `file` is the scenario before the fit, and `run` the breath at the best
/// parameters. `sigma_m3` [samples] is the deviation of the measured samples, or empty. `status` is the word
/// of `fit --json`.
FitRecord fit_record(const ScenarioFile& file, const Trunk& trunk, const SearchSpace& space,
                     const MeasuredCurve& measured, const std::vector<double>& sigma_m3,
                     const Estimation& estimation, const std::string& status, const BreathRun& run,
                     const Provenance& provenance);

}  // namespace trunk
