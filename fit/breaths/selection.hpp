#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "breaths/breath.hpp"

namespace trunk {

/// The user's choice of breaths. Numbers count from 1, as in the list of all breaths.
struct BreathSelection {
  std::vector<std::size_t> excluded, included;  ///< against the program's own judgement
  /// All breaths are scaled so that the kept ones have this median; empty: no scaling.
  std::optional<double> calibrate_tidal_volume_m3;
};

/// Returns the numbers in a text such as "3,7,9-11"; throws InputError at the option if it is anything else,
/// or if a number is outside 1 to 999999.
std::vector<std::size_t> breath_numbers(const std::string& option, const std::string& text);

/// Applies the selection. `source` is the file name of the trace. Throws InputError if a number has no
/// breath, or if it is both excluded and included. => kept, reason
void overrule(std::vector<Breath>& breaths, const BreathSelection& selection, const std::string& source);

}  // namespace trunk
