#pragma once

#include <string>
#include <string_view>

namespace trunk {

/// Returns a number as messages show it: with `digits` significant digits, without trailing zeros, and with a
/// decimal point in every locale. Large numbers keep all digits before the point.
std::string number_text(double value, int digits = 4);

/// Returns the text with "?" for every control character and a space for every line end, so that the content
/// of a file cannot control the terminal.
std::string without_controls(std::string_view text);

/// Returns text of a file as messages quote it: in quotes, without control characters, at most 40 bytes.
std::string excerpt(std::string_view text);

}  // namespace trunk
