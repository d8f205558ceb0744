#pragma once

#include "verdict/assess_fit.hpp"

namespace trunk {

/// Returns one line that says what a result means.
std::string meaning_of(std::string_view result);

/// Returns "0.48 s (0.19 to 1.7 s)".
std::string value_text(const FitResult& result);

/// Returns one to three sentences: the grade, what it rests on, and what would help.
std::string verdict_sentence(const FitResults& results, const FitEvidence& evidence);

}  // namespace trunk
