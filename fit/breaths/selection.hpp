#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "breaths/breath.hpp"

namespace trunk {

/// What the user decides about the breaths of a trace. Numbers count from 1, as in the list of all breaths.
struct BreathSelection {
  std::vector<std::size_t> excluded, included;  ///< against the program's own judgement
  std::optional<double>
      calibrate_tidal_volume_m3;  ///< the median of the kept breaths, to which all are scaled
};

/// "3,7,9-11" as numbers. Throws InputError that begins with `option` for anything else, and for numbers
/// outside 1 to 999999.
std::vector<std::size_t> breath_numbers(const std::string& option, const std::string& text);

/// Overrules the judgement in `breaths`. Throws InputError with `source`, that says how many breaths there
/// are, for a number without a breath, and for one that is both excluded and included.
void overrule(std::vector<Breath>& breaths, const BreathSelection& selection, const std::string& source);

}  // namespace trunk
