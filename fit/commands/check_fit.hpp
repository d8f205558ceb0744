#pragma once

#include <optional>

#include "commands/options/fit_options.hpp"
#include "errors/input_error.hpp"

namespace trunk {

/// Gathers what would make a fit fail or be pointless: unknown, contradictory or idle parameters, values out
/// of bounds, timing set twice. Simulates nothing. The scenario as far as it could be read.
void check_fit(const FitRequest& request, const std::optional<ScenarioFile>& file, Mistakes& mistakes);

}  // namespace trunk
