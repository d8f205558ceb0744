#pragma once

#include <string>

#include "math/units.hpp"
#include "text/message_text.hpp"

namespace trunk {

/// Returns a time for a message.
inline std::string seconds_text(double time_s, int digits = 3) {
  return number_text(time_s, digits) + " s";
}

/// Returns a volume for a message, in ml or in the belt's own unit.
inline std::string volume_text(double volume_m3, bool calibrated) {
  return calibrated ? number_text(volume_m3 * ml_per_m3, 3) + " ml" : number_text(volume_m3, 3) + " a.u.";
}

}  // namespace trunk
