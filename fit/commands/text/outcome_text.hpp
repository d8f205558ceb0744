#pragma once

#include "commands/fit_job.hpp"

namespace trunk {

/// The rows of `fit --breath each`, and what other scenarios come to.
Json breaths_json(const std::vector<BreathRefit>& breaths);
Json predictions_json(const std::vector<Prediction>& predictions);

/// The same as tables; "" of none.
std::string breaths_table(const std::vector<BreathRefit>& breaths);
std::string predictions_table(const std::vector<Prediction>& predictions);

}  // namespace trunk
