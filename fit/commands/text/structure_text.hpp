#pragma once

#include <string>
#include <vector>

#include "results/records.hpp"

namespace trunk {

/// Returns the choices with their ranges, and the part of the variance of each of these numbers that a choice
/// makes up; then what was left out. "" if there is no structure.
std::string structure_table(const Structure& structure, const std::vector<std::string>& numbers);

}  // namespace trunk
