#pragma once

#include "expiration/expired_energy.hpp"

namespace trunk {

/// The law of expired energy. At the end of inspiration the recoil holds the energy E/2 (2 b VT + VT^2) above
/// that of end-expiration, where b is the volume that has not left yet. The muscle only brakes, so the airway
/// takes a share f <= 1 of it: f E (b VT + VT^2/2) = R D. Without a muscle late in expiration b = tau q, and
///
///     f(tau) = tau D / (VT^2/2 + tau q VT),    tau(f) = f VT^2/2 / (D - f q VT),    tau = R/E.
///
/// In eight awake adults f was 24 to 55 % (Shee, Ploy-Song-Sang, Milic-Emili, J Appl Physiol 1985;58:1859).
/// The tool expects ln f to be normal with the mean ln 0.40 and the deviation 0.42, cut off at f = 1 (our
/// choice).
struct EnergyLaw {
  static constexpr double usual_share = 0.40, log_deviation = 0.42;
};

/// The shares between which f lies with a probability of 95 %.
struct ShareLimits {
  double low, high;
};
/// Returns the narrowest such interval of ln f if nothing but the law is known, 0.184 to 0.871. It is
/// symmetric about ln 0.40, though f ends at 1.
ShareLimits share_limits95();

/// Returns f at a time constant tau > 0 s. It may exceed 1, which no passive recoil can do.
double resistive_share(const ExpiredEnergy& energy, double recoil_s);

/// Returns tau at a share f > 0; infinity if the flow late in expiration takes all of f, as no tau is long
/// enough then.
double recoil_time_s(const ExpiredEnergy& energy, double share);

/// A prior as a residual of least squares: its value z and dz/d ln tau.
struct EnergyResidual {
  double z = 0, slope = 0;
};

/// Returns z = (ln f(tau) - ln 0.40) / 0.42 and its slope by ln tau.
EnergyResidual energy_residual(const ExpiredEnergy& energy, double log_recoil_s);

}  // namespace trunk
