#pragma once

#include <cstddef>
#include <string>

namespace trunk {

/// One whole breath of a trace. Times are those of the trace.
struct Breath {
  double onset_s = 0, peak_s = 0, end_s = 0;  ///< begin and end of inspiration, end of expiration
  double tidal_volume_m3 = 0;                 ///< top above the line from onset to end
  bool kept = true;
  std::string reason;      ///< why it is rejected, or kept nevertheless; otherwise empty
  double pause_s = 0;      ///< rest before end_s; it is part of the expiration
  double inspired_m3 = 0;  ///< rise from onset to peak, before any drift or leak is removed
  double expired_m3 = 0;   ///< fall from peak to end, before any drift or leak is removed
  std::size_t number = 0;  ///< among all breaths of the trace, from 1

  double inspiration_s() const { return peak_s - onset_s; }
  double expiration_s() const { return end_s - peak_s; }
  double duration_s() const { return end_s - onset_s; }
  double ventilation_m3_s() const { return tidal_volume_m3 / duration_s(); }
};

}  // namespace trunk
