#pragma once

#include <memory>
#include <string>

#include "recordings/recording.hpp"

namespace trunk {

/// Returns a text table (see DelimitedText) as a recording. If the first filled cell of a column is a clock
/// time, the column is read in seconds since its first time, and its unit is "s". Cells without a number are
/// flaws. Throws as DelimitedText does, and for more than 10000 flaws.
std::unique_ptr<Recording> recording_of_text(std::string source, std::string text);

}  // namespace trunk
