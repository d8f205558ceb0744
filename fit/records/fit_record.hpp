#pragma once

#include "estimation/estimate.hpp"
#include "results/records.hpp"
#include "scenarios/read_scenario.hpp"

namespace trunk {

/// `status` is as in `fit --json`. `sigma_m3` is the deviation of the measured samples, or empty. `run` is
/// the breath at the best parameters, `file` the scenario before the fit.
FitRecord fit_record(const ScenarioFile& file, const Trunk& trunk, const SearchSpace& space,
                     const MeasuredCurve& measured, const std::vector<double>& sigma_m3,
                     const Estimation& estimation, const std::string& status, const BreathRun& run,
                     const Provenance& provenance);

}  // namespace trunk
