#pragma once

#include <string>
#include <string_view>

namespace trunk {

/// A number as a message shows it: `digits` significant digits (more before the point of a large number), no
/// trailing zeros, no locale.
std::string number_text(double value, int digits = 4);

/// Returns the text with every control character as "?", and line ends as blanks: what came out of a file
/// cannot steer a terminal.
std::string without_controls(std::string_view text);

/// Text of a file as a message cites it: in quotes, control characters replaced, at most 40 bytes.
std::string excerpt(std::string_view text);

}  // namespace trunk
