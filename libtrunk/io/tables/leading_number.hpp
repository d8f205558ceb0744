#pragma once

#include <string>
#include <string_view>

namespace trunk {

/// A text that begins with a number, such as "0,01 s" or "±10.000 L/s".
struct LeadingNumber {
  double value = 0;  ///< NaN if the text does not begin with a number
  std::string rest;  ///< without spaces at either end: "s"
};

/// Reads the number at the front of a text. The decimal mark may be a comma, and a sign may be "±".
LeadingNumber leading_number(std::string_view text);

}  // namespace trunk
