#pragma once

#include <string>
#include <vector>

#include "io/trace.hpp"

namespace trunk {

/// One whole breath of a trace.
struct Breath {
  double onset_s = 0, peak_s = 0,
         end_s = 0;            ///< time of the trace: begin and end of inspiration, end of expiration
  double tidal_volume_m3 = 0;  ///< maximum above the line from onset to end
  bool kept = true;
  std::string reason;  ///< why it was rejected, in words; empty when kept
};

/// A trace as volume without drift, and its breaths in order: one ends where the next begins.
struct Segmentation {
  std::vector<double> time_s, volume_m3;  ///< [samples] 0 at every end of expiration
  std::vector<Breath> breaths;            ///< at least one, at least one kept
  std::vector<std::string> notes;         ///< of the trace, then what was repaired, removed or looks odd
  std::vector<double> sigma_m3;           ///< [samples] as the trace gave it, or empty
  std::string source;                     ///< of the trace, for messages
};

/// Trace => breaths: repair and integrate (volume_signal), find turning points (whole_breaths), place onsets
/// and peaks (landmarks), remove the drift (line from one end of expiration to the next), judge every breath.
///
/// A breath is rejected when its tidal volume or duration is under half or over twice the median, when
/// inspiration takes less than 10 % or more than 90 % of it, or when, drift aside, it ends more than half a
/// tidal volume from where it began (all our choice).
///
/// Throws InputError with the trace's source: a constant signal, less than one whole breath, a median period
/// outside 0.8..30 s, a median tidal volume outside 30..6000 ml (the last two name the unit that would make
/// sense).
Segmentation segment_breaths(const Trace& trace);

}  // namespace trunk
