#pragma once

#include <string>

namespace trunk {

struct Uncertainty;

/// One or two sentences: what the data determine, how well, and what would help.
std::string verdict_of(const Uncertainty& uncertainty);

}  // namespace trunk
