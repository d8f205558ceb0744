#include "expiration/energy_law.hpp"

#include <gsl/gsl_cdf.h>

#include <cmath>
#include <limits>

namespace trunk {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// Returns the jackknife's standard error of ln tau at a share; 0 if breaths show none.
double log_error(const std::vector<ExpiredEnergy>& without_each, double share) {
  const auto n = static_cast<double>(without_each.size());
  if (n < 3) return 0;
  double sum = 0, squares = 0;
  for (const ExpiredEnergy& energy : without_each) {
    const double log_tau = std::log(recoil_time_s(energy, share));
    if (!std::isfinite(log_tau)) return infinite;
    sum += log_tau / n;
  }
  for (const ExpiredEnergy& energy : without_each)
    squares += std::pow(std::log(recoil_time_s(energy, share)) - sum, 2);
  return std::sqrt((n - 1) / n * squares);
}

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

RecoilTime recoil_time(const MeasuredBreath& breath) {
  const ExpiredEnergy e = expired_energy(breath);
  const auto without_each = expired_energy_without_each(breath);
  const ShareLimits share = share_limits95();
  RecoilTime recoil;
  recoil.median_s = recoil_time_s(e, EnergyLaw::usual_share);
  recoil.late_share = e.late_flow_m3_s * e.expiration_s / e.tidal_volume_m3;
  recoil.has_upper_limit = e.squared_flow > e.late_flow_m3_s * e.tidal_volume_m3;
  recoil.log_error = log_error(without_each, EnergyLaw::usual_share);
  const double spread =
      without_each.empty()
          ? 0
          : recoil.log_error * gsl_cdf_tdist_Pinv(0.975, static_cast<double>(without_each.size() - 1));
  const auto widened = [&](double limit) {
    return std::hypot(std::log(recoil_time_s(e, limit) / recoil.median_s), spread);
  };
  recoil.lower95_s = recoil.median_s * std::exp(-widened(share.low));
  recoil.upper95_s = recoil.has_upper_limit ? recoil.median_s * std::exp(widened(share.high)) : infinite;
  return recoil;
}

}  // namespace trunk
