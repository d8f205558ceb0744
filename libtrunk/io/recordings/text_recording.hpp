#pragma once

#include <memory>
#include <string>

#include "recordings/recording.hpp"

namespace trunk {

/// A table in text (see DelimitedText) as a recording. A column whose first filled cell is a clock time (see
/// clock_time) is read as seconds since its first, and its unit is "s". Cells without a number are flaws, at
/// most 10000. Throws InputError as DelimitedText does for header and rows.
std::unique_ptr<Recording> recording_of_text(std::string source, std::string text);

}  // namespace trunk
