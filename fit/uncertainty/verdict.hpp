#pragma once

#include <string>

namespace trunk {

struct Uncertainty;

/// Returns one to three sentences: what the trace determines, how well, and what would help.
std::string verdict_of(const Uncertainty& uncertainty);

}  // namespace trunk
