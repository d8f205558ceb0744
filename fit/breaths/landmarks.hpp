#pragma once

#include <span>
#include <vector>

#include "breaths/knot_line.hpp"
#include "breaths/whole_breaths.hpp"

namespace trunk {

/// Where n whole breaths begin, peak and end: breath i runs from rest i over peak i to rest i+1.
struct Landmarks {
  KnotLine rest;                     ///< onsets, [n+1]: time s, volume at rest there, before drift removal
  std::vector<double> rests_s;       ///< [n+1] how long the volume was level before that time
  std::vector<double> peak_s;        ///< [n] end of inspiration; the middle of a plateau
  std::vector<double> tidal_volume;  ///< [n] top above the line between the two rests
};

/// Places the landmarks of breaths found in the same samples (at least one breath), free of the unit of
/// volume.
///
/// Each rest and each top is fitted as a turn (fit_turn) to what lies near it: a tenth of a breath's height,
/// more in noise (turn_windows). All rests have one shape, all tops another: those that fit best. An onset is
/// the end of its rest, and so lies at the end of a pause; it is where the volume leaves rest, which is later
/// than the muscle's onset where the expiration before it has not ended. A peak is the middle of its top.
Landmarks landmarks(std::span<const double> time_s, std::span<const double> volume,
                    const WholeBreaths& breaths);

}  // namespace trunk
