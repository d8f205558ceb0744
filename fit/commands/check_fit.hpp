#pragma once

#include <optional>

#include "commands/fit_options.hpp"
#include "errors/input_error.hpp"

namespace trunk {

/// Gathers what would make a fit fail or be pointless: unknown, contradictory or idle parameters, values out
/// of bounds, timing set twice. Simulates nothing. Scenario and breath as far as they could be read.
void check_fit(const FitRequest& request, const std::optional<ScenarioFile>& file,
               const std::optional<MeasuredBreath>& breath, Mistakes& mistakes);

}  // namespace trunk
