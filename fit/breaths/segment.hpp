#pragma once

#include <optional>
#include <string>
#include <vector>

#include "breaths/breath.hpp"
#include "breaths/knot_line.hpp"
#include "breaths/selection.hpp"
#include "breaths/time_window.hpp"
#include "traces/trace.hpp"

namespace trunk {

/// A trace as volume without drift, and its breaths in order: each ends where the next one begins.
struct Segmentation {
  std::vector<double> time_s, volume_m3;  ///< [samples] 0 at every end of expiration
  std::vector<Breath> breaths;            ///< at least one; possibly none is kept
  std::vector<std::string> notes;  ///< those of the trace, then what was repaired, removed or looks odd
  std::vector<double> sigma_m3;    ///< [samples] sigma of the trace, or empty
  std::string source;              ///< file name of the trace, for messages
  bool calibrated = true;          ///< false for a belt: members in m3 are in the belt's own unit
  KnotLine rest;  ///< [breaths+1] the ends of expiration: time s, and volume m3 before drift is removed
  std::vector<TraceChannel> channels{};   ///< those of the trace, [samples] as volume_m3
  std::optional<double> excursion_m{};    ///< of a dome over a breath, if one number was measured
  SignShownBy sign = SignShownBy::shape;  ///< what shows which way is up
  std::optional<TimeWindow> window{};     ///< all of this is inside it, if the user chose one
};

/// Returns the breaths of a trace. The steps are: repair and integrate (volume_signal), find turning points
/// (whole_breaths), place onsets and peaks (landmarks), remove the drift (a line from each end of expiration
/// to the next), judge every breath, apply the user's selection, and scale if a tidal volume is given.
///
/// A breath is rejected if its tidal volume or duration is under half or over twice the median, if
/// inspiration takes less than 10 % or more than 90 % of it, or if it ends more than half a tidal volume from
/// where it began while the median breath and both neighbours do not (all our choice). It is no error if all
/// breaths are rejected; mean_breath then throws.
///
/// Throws InputError if the signal is constant, hardly comes back (see one_way.hpp), has no whole breath, has
/// a median period outside 0.8 to 30 s or under 6 samples, or a median tidal volume outside 30 to 6000 ml
/// (see plausibility.hpp; the volume is not checked for a belt or if a tidal volume is given), or if the
/// selection names a breath that does not exist or a window without one.
Segmentation segment_breaths(const Trace& trace, const BreathSelection& selection = {});

}  // namespace trunk
