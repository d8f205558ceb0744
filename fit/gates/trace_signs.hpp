#pragma once

#include "breaths/segment.hpp"
#include "gates/upside_down.hpp"

namespace trunk {

/// What the breaths of a recording look like, as far as it says whether they can be fitted. Medians over the
/// kept breaths, or over all if none is kept.
struct TraceSigns {
  Orientation orientation;
  /// Inspired less expired volume over their mean, before any drift is removed: a gain that differs with the
  /// direction of flow, or an offset.
  double gain_mismatch = 0;
  /// It grows with the size of a breath rather than with its duration, or the other way round. Both are false
  /// for fewer than 5 breaths, and where breaths do not show it.
  bool mismatch_by_size = false, mismatch_by_duration = false;
  /// Standard deviation of the end-expiratory level over VT after a line is removed: the median over blocks
  /// of at most 60 breaths (our choice), since an integrated flow strays over hours and no breath notices.
  double wander = 0;
  double tidal_volume_m3 = 0;  ///< of a belt, in its own unit
  double inspiration_s = 0;
  double inspired_part = 0.4;  ///< of a breath, in time
  double step_s = 0;           ///< between samples, mean
  std::size_t breaths = 0;     ///< kept
};

TraceSigns trace_signs(const Segmentation& segmentation);

}  // namespace trunk
