#pragma once

#include <string>
#include <vector>

#include "clinic/clinic.hpp"

namespace trunk {

/// Returns the numbers of a clinic as a table: a row for each breath of `used`, then the mean over breaths
/// with its 95 % interval, and the number of the mean breath. "" if there are none.
std::string clinic_table(const std::vector<ClinicNumber>& numbers, const std::vector<Breath>& used);

/// Returns one line for each number: mean, interval and unit. "" if there are none.
std::string clinic_lines(const std::vector<ClinicNumber>& numbers);

}  // namespace trunk
