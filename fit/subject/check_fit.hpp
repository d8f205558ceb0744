#pragma once

#include <optional>

#include "errors/input_error.hpp"
#include "subject/fit_request.hpp"

namespace trunk {

/// Adds to `mistakes` all that would make a fit fail or be pointless: parameters that are unknown, named
/// twice or without effect, values out of bounds, timing that the trace would overwrite. Simulates nothing.
/// `file` is the scenario, if it could be read.
void check_fit(const FitRequest& request, const std::optional<ScenarioFile>& file, Mistakes& mistakes);

}  // namespace trunk
