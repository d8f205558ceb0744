#pragma once

#include "verdict/fit_results.hpp"

namespace trunk {

/// Returns what a result is called on a terminal: "recoil time" for recoil_time_s.
std::string title_of(const std::string& result);

/// Returns "0.50 (0.20 to 1.70) s". The last digit is the second one of the shorter side of the interval, so
/// that no digit is shown that nobody knows. A result without a value is "withheld".
std::string interval_text(const FitResult& result);

/// Returns the results that are shown first, with interval, grade and meaning, and what straight lines give.
/// Assumptions and reasons stand once below, with the numbers by which the grades name them; a star is for
/// the reason that the verdict gives.
std::string results_table(const FitResults& results);

/// Returns the verdict, after a star if the table refers to it.
std::string verdict_text(const FitResults& results);

}  // namespace trunk
