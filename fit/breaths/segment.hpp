#pragma once

#include <string>
#include <vector>

#include "breaths/breath.hpp"
#include "breaths/selection.hpp"
#include "traces/trace.hpp"

namespace trunk {

/// A trace as volume without drift, and its breaths in order: one ends where the next begins.
struct Segmentation {
  std::vector<double> time_s, volume_m3;  ///< [samples] 0 at every end of expiration
  std::vector<Breath> breaths;            ///< at least one; perhaps none kept
  std::vector<std::string> notes;         ///< of the trace, then what was repaired, removed or looks odd
  std::vector<double> sigma_m3;           ///< [samples] as the trace gave it, or empty
  std::string source;                     ///< of the trace, for messages
  bool calibrated = true;                 ///< else a belt: all that is called m3 is in units of its own
};

/// Trace => breaths: repair and integrate (volume_signal), find turning points (whole_breaths), place onsets
/// and peaks (landmarks), remove the drift (line from one end of expiration to the next), judge every breath,
/// follow the user's selection, scale where a tidal volume is given.
///
/// A breath is rejected when its tidal volume or duration is under half or over twice the median, when
/// inspiration takes less than 10 % or more than 90 % of it, or when it ends more than half a tidal volume
/// from where it began, unlike the median, the one before and the one after (all our choice). Where none is
/// left, mean_breath throws.
///
/// Throws InputError with the trace's source: a constant signal, less than one whole breath, a median period
/// outside 0.8..30 s, a median tidal volume outside 30..6000 ml (both name the unit that would make sense;
/// the latter not of a belt, nor where a tidal volume is given), a selection of breaths that are not there.
Segmentation segment_breaths(const Trace& trace, const BreathSelection& selection = {});

}  // namespace trunk
