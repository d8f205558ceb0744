#pragma once

#include "breaths/mean_breath.hpp"

namespace trunk {

/// How much an expiration looks like that of a relaxed chest: volume V = tau (-V') + offset.
struct PassiveExpiration {
  double recoil_s = 0;   ///< tau
  double r_squared = 0;  ///< of the straight line
  double offset_of_tidal_volume = 0;
  bool straight = false;  ///< r_squared >= 0.98 and |offset| <= 0.2 VT
};

/// Returns the least-squares line of volume on flow, from peak expiratory flow until 5 % of the tidal volume
/// are left. It is no proof of relaxation: a muscle that fades in time with the recoil gives a straight line
/// too. So it counts only if the expiration is known to be passive.
PassiveExpiration passive_expiration(const MeasuredBreath& breath);

}  // namespace trunk
