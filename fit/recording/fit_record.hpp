#pragma once

#include "estimation/estimate.hpp"
#include "io/scenario_file.hpp"
#include "results/records.hpp"

namespace trunk {

/// `status` is as in `fit --json`. `run` is the breath at the best parameters.
FitRecord fit_record(const ScenarioFile& file, const Trunk& trunk, const SearchSpace& space,
                     const Target& target, const MeasuredBreath& breath, const Estimation& estimation,
                     const SearchOptions& options, const std::string& status, const BreathRun& run,
                     const Provenance& provenance);

}  // namespace trunk
