#pragma once

#include <numbers>

namespace trunk {

// All values inside the program are in SI units; these factors take values that people read and write to SI
// units and back. A factor's name says how to use it: `m_per_mm * length_mm` is a length in m, and
// `mm_per_m * length_m` is one in mm. Both directions are here since x / 1e-3 and 1e3 * x may differ in the
// last bit.
inline constexpr double m_per_mm = 1e-3, mm_per_m = 1e3;
inline constexpr double m3_per_ml = 1e-6, ml_per_m3 = 1e6;
inline constexpr double m3_per_litre = 1e-3, litres_per_m3 = 1e3;
inline constexpr double s_per_ms = 1e-3, ms_per_s = 1e3;
inline constexpr double s_per_min = 60.0;
inline constexpr double Pa_per_cmH2O = 98.0665, Pa_per_mmHg = 133.322387415;
inline constexpr double rad_per_degree = std::numbers::pi / 180.0, degrees_per_rad = 180.0 / std::numbers::pi;
inline constexpr double percent_per_one = 100.0;  // times a fraction: 0.05 is 5 %

}  // namespace trunk
