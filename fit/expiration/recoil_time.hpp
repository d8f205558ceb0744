#pragma once

#include "expiration/share_posterior.hpp"

namespace trunk {

/// The recoil time constant that the energy law gives, with all else that is known of it.
struct RecoilTime {
  double lower95_s = 0, median_s = 0, upper95_s = 0;  ///< infinite where there is no limit
  double log_error = 0;         ///< standard error of ln tau by the spread of the breaths; part of the limits
  double late_share = 0;        ///< q Te / VT: how far the end of expiration is from rest
  bool has_upper_limit = true;  ///< false if D <= q VT: the flow does not fade, so f = 1 has no tau
};

/// Returns the recoil time constant and its 95 % interval. The limits are those of the share of the airway,
/// widened by the spread of the breaths: the jackknife's standard error of ln tau, times t of B - 1 degrees
/// of freedom, is added to either half-width as the root of the sum of squares. One or two breaths show no
/// spread; it then counts as none.
RecoilTime recoil_time(const MeasuredBreath& breath, const RecoilDeviance& beside = {});

}  // namespace trunk
