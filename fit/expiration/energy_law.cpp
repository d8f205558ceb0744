#include "expiration/energy_law.hpp"

#include <gsl/gsl_cdf.h>

#include <cmath>
#include <limits>

namespace trunk {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

}  // namespace

ShareLimits share_limits95() {
  const double below_one = gsl_cdf_ugaussian_P(-std::log(EnergyLaw::usual_share) / EnergyLaw::log_deviation);
  const double reach = EnergyLaw::log_deviation * gsl_cdf_ugaussian_Pinv(0.5 + 0.5 * 0.95 * below_one);
  return {EnergyLaw::usual_share * std::exp(-reach), EnergyLaw::usual_share * std::exp(reach)};
}

double resistive_share(const ExpiredEnergy& e, double recoil_s) {
  return recoil_s * e.squared_flow /
         (0.5 * e.tidal_volume_m3 * e.tidal_volume_m3 + recoil_s * e.late_flow_m3_s * e.tidal_volume_m3);
}

double recoil_time_s(const ExpiredEnergy& e, double share) {
  const double excess = e.squared_flow - share * e.late_flow_m3_s * e.tidal_volume_m3;
  return excess > 0 ? 0.5 * share * e.tidal_volume_m3 * e.tidal_volume_m3 / excess : infinite;
}

EnergyResidual energy_residual(const ExpiredEnergy& e, double log_recoil_s) {
  const double tau = std::exp(log_recoil_s);
  const double share = resistive_share(e, tau);
  const double slope = 0.5 * e.tidal_volume_m3 / (0.5 * e.tidal_volume_m3 + tau * e.late_flow_m3_s);
  return {std::log(share / EnergyLaw::usual_share) / EnergyLaw::log_deviation,
          slope / EnergyLaw::log_deviation};
}

}  // namespace trunk
