#pragma once

#include <cstddef>
#include <vector>

#include "breaths/segment.hpp"

namespace trunk {

/// The breath a fit is held against, on an even grid of time from 0 (onset) to duration_s, both included.
struct MeasuredBreath {
  std::vector<double> time_s;             ///< [samples]
  std::vector<double> volume_m3;          ///< [samples] above end-expiration; exactly 0 at both ends
  std::vector<double> sigma_m3;           ///< [samples] > 0; see mean_breath and single_breath
  std::vector<double> standard_error_m3;  ///< [samples] of volume_m3: sigma_m3 over the root of breaths_used
  double inspiration_s = 0, duration_s = 0, tidal_volume_m3 = 0;  ///< means of the breaths used
  double pause_s = 0;  ///< mean rest at the end of expiration, part of duration_s
  int breaths_used = 0, breaths_rejected = 0;
};

/// The mean of the kept breaths. Inspirations and expirations are stretched, each linearly, to their mean
/// durations, so that peaks meet; then volumes are averaged. sigma is the standard deviation over breaths
/// (noise of one breath when fewer than three are kept), the trace's own sigma where that is larger, and at
/// least 1 % of the tidal volume: the breaths agree exactly where they are set to 0, and no spirometer is
/// better (our choice).
///
/// Throws InputError with the source: samples < 3, no breath kept, a belt that is not calibrated.
MeasuredBreath mean_breath(const Segmentation& segmentation, int samples = 200);

/// Breath `number`, counted from 1 as in the list shown to the user, kept or not. sigma is the trace's own
/// where given, else the noise of the volume; at least 1 % of the tidal volume.
///
/// Throws InputError with the source: no such breath, samples < 3, a belt that is not calibrated.
MeasuredBreath single_breath(const Segmentation& segmentation, std::size_t number, int samples = 200);

}  // namespace trunk
