#pragma once

#include "subject/fit_outcome.hpp"

namespace trunk {

/// Returns the rows of `fit --breath each` as a table; "" if there are none.
std::string breaths_table(const std::vector<BreathRefit>& breaths);

/// Returns one line for each scenario that was predicted; "" if there are none.
std::string predictions_table(const std::vector<Prediction>& predictions, bool detailed);

}  // namespace trunk
