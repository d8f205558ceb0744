#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "breaths/breath.hpp"

namespace trunk {

/// The user's choice of breaths. Numbers count from 1 over the whole recording, as in the list of
/// all breaths, whatever the window is.
struct BreathSelection {
  std::vector<std::size_t> excluded, included;  ///< against the program's own judgement
  /// All breaths are scaled so that the kept ones have this median; empty: no scaling.
  std::optional<double> calibrate_tidal_volume_m3;
  std::optional<double> begin_s{}, end_s{};  ///< only breaths between these times of the trace are used
};

/// Returns where the breath of this number is in a list; nothing if it is not there.
std::optional<std::size_t> position_of(const std::vector<Breath>& breaths, std::size_t number);

/// Returns the numbers in a text such as "3,7,9-11"; throws InputError at the option if it is anything else,
/// or if a number is outside 1 to 999999.
std::vector<std::size_t> breath_numbers(const std::string& option, const std::string& text);

/// Applies the selection. `source` is the file name of the trace. Throws InputError if a number has no
/// breath, or if it is both excluded and included. => kept, reason
void overrule(std::vector<Breath>& breaths, const BreathSelection& selection, const std::string& source);

}  // namespace trunk
