#pragma once

#include <vector>

#include "breaths/mean_breath.hpp"

namespace trunk {

/// One breath: volume, its flow and the pressures, from its onset on. Pressures are changes from the moment
/// at which inspiratory flow begins; one that was not measured in this breath is empty. Of pleural, gastric
/// and transdiaphragmatic pressure, two give the third (Pdi = Pga - Ppl).
struct BreathLoop {
  double inspiration_s = 0;  ///< until flow turns
  double duration_s = 0;
  double flow_begins_s = 0;                          ///< the next breath's flow, at the end of this one
  std::vector<double> time_s, volume_m3, flow_m3_s;  ///< [samples]
  std::vector<double> pleural_Pa, gastric_Pa, transdiaphragmatic_Pa, airway_Pa;

  /// Returns the volume at the end of inspiration, m3.
  double tidal_volume_m3() const;
  /// Returns the pressure across the lung: airway (0 if it was not measured) less pleural, Pa.
  std::vector<double> transpulmonary_Pa() const;
};

/// Returns the loop of the mean breath, and of the breath at a position in `used`. The flow is the slope of
/// the volume over 0.05 s on either side, as if the breath repeated. It begins where it exceeds 3 % of its
/// peak, which for a flow that rises steadily is where it leaves 0, within the last 0.3 s; and inspiration
/// ends where the slope between neighbours changes its sign, within a fifth of either phase (our choice).
BreathLoop mean_loop(const MeasuredBreath& breath);
BreathLoop loop_of(const MeasuredBreath& breath, std::size_t used);

/// Returns the integral of `values` over inspiration, by trapezia: over time, and over the volume.
double over_inspiration(const BreathLoop& loop, const std::vector<double>& values);
double over_inspired_volume(const BreathLoop& loop, const std::vector<double>& values);
/// Returns the integral over the volume that is expired, positive for positive values.
double over_expired_volume(const BreathLoop& loop, const std::vector<double>& values);
/// Returns the value at the end of inspiration.
double at_end_inspiration(const BreathLoop& loop, const std::vector<double>& values);

}  // namespace trunk
