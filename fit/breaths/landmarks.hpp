#pragma once

#include <span>
#include <vector>

#include "breaths/knot_line.hpp"
#include "breaths/whole_breaths.hpp"

namespace trunk {

/// Where n whole breaths begin, peak and end: breath i runs from rest i over peak i to rest i+1.
struct Landmarks {
  KnotLine rest;                        ///< ends of expiration, [n+1]: time s, volume m3 before drift removal
  std::vector<double> peak_s;           ///< [n] end of inspiration; the middle of a plateau
  std::vector<double> tidal_volume_m3;  ///< [n] maximum above the line between the two rests
};

/// Places the landmarks of breaths found in the same samples (at least one breath).
///
/// An onset is extrapolated: volume leaves rest about as the square of time, so that an inspiration which
/// passes a level at t1 and four times that level at t4 began at 2 t1 - t4. The level is 2 % of the height,
/// or three deviations of the noise up to 10 % (our choice). The result is kept between the minimum before it
/// and t1, and so lies at the end of a pause, where the minimum may be anywhere. A peak is the middle of what
/// lies within 1 % of the maximum.
Landmarks landmarks(std::span<const double> time_s, std::span<const double> volume_m3,
                    const WholeBreaths& breaths);

}  // namespace trunk
