#include "expiration/recoil_time.hpp"

#include <gsl/gsl_cdf.h>

#include <cmath>
#include <limits>

namespace trunk {
namespace {

constexpr double no_limit = std::numeric_limits<double>::infinity();

// Returns the jackknife's standard error of ln tau at a share; 0 if breaths show none.
double log_error(const std::vector<ExpiredEnergy>& without_each, double share) {
  const auto n = static_cast<double>(without_each.size());
  if (n < 3) return 0;
  double sum = 0, squares = 0;
  for (const ExpiredEnergy& energy : without_each) {
    const double log_tau = std::log(recoil_time_s(energy, share));
    if (!std::isfinite(log_tau)) return no_limit;
    sum += log_tau / n;
  }
  for (const ExpiredEnergy& energy : without_each)
    squares += std::pow(std::log(recoil_time_s(energy, share)) - sum, 2);
  return std::sqrt((n - 1) / n * squares);
}

}  // namespace

RecoilTime recoil_time(const MeasuredBreath& breath, const RecoilDeviance& beside) {
  const ExpiredEnergy e = expired_energy(breath);
  const auto without_each = expired_energy_without_each(breath);
  const SharePosterior posterior(e, beside);
  const ShareLimits share = posterior.limits95();
  RecoilTime recoil;
  recoil.median_s = recoil_time_s(e, posterior.mode());
  recoil.late_share = e.late_flow_m3_s * e.expiration_s / e.tidal_volume_m3;
  recoil.has_upper_limit = e.squared_flow > e.late_flow_m3_s * e.tidal_volume_m3;
  recoil.log_error = posterior.weight_of_law() * log_error(without_each, EnergyLaw::usual_share);
  const double spread =
      without_each.empty()
          ? 0
          : recoil.log_error * gsl_cdf_tdist_Pinv(0.975, static_cast<double>(without_each.size() - 1));
  const auto widened = [&](double limit) {
    return std::hypot(std::log(recoil_time_s(e, limit) / recoil.median_s), spread);
  };
  recoil.lower95_s = recoil.median_s * std::exp(-widened(share.low));
  recoil.upper95_s = recoil.has_upper_limit ? recoil.median_s * std::exp(widened(share.high)) : no_limit;
  return recoil;
}

}  // namespace trunk
