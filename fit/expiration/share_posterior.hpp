#pragma once

#include <vector>

#include "expiration/energy_law.hpp"

namespace trunk {

/// What all else says of the recoil time: -2 log of its likelihood, from fits at given recoil times. Between
/// them it is interpolated, and beyond them it stays what it is at the end.
struct RecoilDeviance {
  std::vector<double> log_recoil_s, deviance;  ///< [0 or 3 and more] increasing in time; empty: nothing
};

/// The share f of the airway, given the energy law and all else that is known of the recoil time. ln f is
/// normal about the usual share and cut off at f = 1; its density is multiplied by exp(-deviance / 2) at the
/// recoil time that f gives.
class SharePosterior {
 public:
  explicit SharePosterior(const ExpiredEnergy& energy, const RecoilDeviance& beside = {});

  /// Returns the narrowest interval of ln f that holds 95 %.
  ShareLimits limits95() const;

  /// Returns the most likely share.
  double mode() const noexcept { return mode_; }

  /// Returns the share that has this part of the posterior below it, 0 < part < 1.
  double share_at(double part) const;

  /// Returns how much of what is known of ln f is the law's: the posterior's variance over the law's, 1 if
  /// nothing else is known. An error of the law moves the result by this part of it.
  double weight_of_law() const noexcept { return weight_; }

 private:
  std::vector<double> log_share_,
      below_;  // a fine grid, and the part of the posterior up to each of its points
  double mode_ = EnergyLaw::usual_share, weight_ = 1.0;
};

}  // namespace trunk
