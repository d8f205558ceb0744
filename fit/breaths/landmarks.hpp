#pragma once

#include <span>
#include <vector>

#include "breaths/knot_line.hpp"
#include "breaths/whole_breaths.hpp"

namespace trunk {

/// Where n whole breaths begin, peak and end: breath i goes from rest i through peak i to rest i+1.
struct Landmarks {
  KnotLine rest;                     ///< [n+1] onsets: time s, and volume at rest before drift is removed
  std::vector<double> rests_s;       ///< [n+1] how long the volume was level before that time, s
  std::vector<double> peak_s;        ///< [n] end of inspiration; the middle of a plateau
  std::vector<double> tidal_volume;  ///< [n] top above the line between the two rests
};

/// Returns the landmarks of breaths that were found in the same samples (at least one breath). Volumes may be
/// in any unit.
///
/// Each rest and each top is fitted as a turn (fit_turn) to the samples near it: a tenth of a breath's
/// height, more if there is noise (turn_windows). All rests have the same shape, and all tops have another
/// one: the shapes that fit best. An onset is the end of its rest, so it comes after a pause. It is the time
/// at which the volume leaves rest; the muscle starts earlier if the expiration before has not ended. A peak
/// is the middle of its top.
Landmarks landmarks(std::span<const double> time_s, std::span<const double> volume,
                    const WholeBreaths& breaths);

}  // namespace trunk
