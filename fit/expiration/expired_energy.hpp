#pragma once

#include <vector>

#include "breaths/mean_breath.hpp"

namespace trunk {

/// What an expiration tells about the energy that its flow turns into heat. All in SI units.
struct ExpiredEnergy {
  double squared_flow = 0;    ///< D, m6/s: the integral over expiration of the squared flow
  double late_flow_m3_s = 0;  ///< q: median expiratory flow from 85 to 93 % of expiration; 0 if there is none
  double expiration_s = 0;    ///< Te
  double tidal_volume_m3 = 0;  ///< VT
};

/// Returns the energy of a mean breath. The flow is the slope of straight lines through the samples within
/// 50 ms (our choice: a half sine of 1 s loses 0.5 % of D). Noise that differs from breath to breath is left
/// out of D: what is integrated is the product of the flows of two different breaths, averaged over all
/// pairs. A single breath has no pair, and white noise of n m3 in its volume adds to D about as much as Te (n
/// / 50 ms)^2 over a third of the samples in 100 ms.
ExpiredEnergy expired_energy(const MeasuredBreath& breath);

/// Returns the same of all breaths but one, for each that is left out; empty for fewer than three breaths.
std::vector<ExpiredEnergy> expired_energy_without_each(const MeasuredBreath& breath);

/// Returns the flow of a volume on an even grid, m3/s: the slope of the straight line through the samples
/// within `reach_s`, and at least one on either side where there is one.
std::vector<double> flow_of(const std::vector<double>& volume_m3, double step_s, double reach_s = 0.05);

}  // namespace trunk
