#pragma once

#include <numbers>

namespace trunk {

inline constexpr double Pa_per_cmH2O = 98.0665;
inline constexpr double rad_per_degree = std::numbers::pi / 180.0;

}  // namespace trunk
