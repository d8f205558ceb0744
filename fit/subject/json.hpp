#pragma once

#include <cmath>
#include <nlohmann/json.hpp>

namespace trunk {

/// JSON whose keys keep the order in which they are added.
using Json = nlohmann::ordered_json;

/// Returns the number, or null if it is not finite: JSON has no NaN.
inline Json json_number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

}  // namespace trunk
