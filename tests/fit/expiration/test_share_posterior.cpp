#include "expiration/share_posterior.hpp"

#include <cmath>

#include "support/catch.hpp"

using namespace trunk;

namespace {

// The flow has stopped before expiration ends, so that ln tau = ln f + a constant.
const ExpiredEnergy energy_at_rest{0.5e-6, 0.0, 2, 1e-3};

// What a normal measurement of ln tau says.
RecoilDeviance measured(double log_recoil_s, double deviation) {
  RecoilDeviance known;
  for (int i = -70; i <= 70; ++i) {
    const double z = 0.1 * i;
    known.log_recoil_s.push_back(log_recoil_s + z * deviation);
    known.deviance.push_back(3.0 + z * z);  // a constant says nothing
  }
  return known;
}

}  // namespace

TEST_CASE("If nothing else is known, the share has the interval of the law", "[unit][expiration]") {
  const SharePosterior posterior(energy_at_rest);
  CHECK(posterior.limits95().low == Approx(share_limits95().low).epsilon(2e-3));
  CHECK(posterior.limits95().high == Approx(share_limits95().high).epsilon(2e-3));
  CHECK(posterior.mode() == EnergyLaw::usual_share);
  CHECK(posterior.weight_of_law() == 1.0);
  CHECK(posterior.share_at(1 - 1e-9) == Approx(1.0).epsilon(2e-3));
}

TEST_CASE("Two normal statements on the recoil time make one", "[property][expiration]") {
  // The product of two normal laws: precisions add up, and the mean is weighed by them.
  const double deviation = GENERATE(0.05, 0.2), shift = GENERATE(-0.8, 0.3);
  const double usual = std::log(recoil_time_s(energy_at_rest, EnergyLaw::usual_share));
  const SharePosterior posterior(energy_at_rest, measured(usual + shift, deviation));
  const double law = std::pow(EnergyLaw::log_deviation, -2), data = std::pow(deviation, -2);
  const double mean = std::log(EnergyLaw::usual_share) + data * shift / (law + data);
  const double reach = 1.96 / std::sqrt(law + data);
  CAPTURE(deviation, shift);
  CHECK(std::log(posterior.limits95().low) == Approx(mean - reach).margin(0.02 * reach));
  CHECK(std::log(posterior.limits95().high) == Approx(mean + reach).margin(0.02 * reach));
  CHECK(std::log(posterior.mode()) == Approx(mean).margin(0.02 * reach));
  // The law ends at f = 1, which makes its variance smaller than that of the whole normal law.
  CHECK(posterior.weight_of_law() == Approx(law / (law + data)).epsilon(0.2));
}

TEST_CASE("A known recoil time leaves no room for another one", "[unit][expiration]") {
  const double usual = std::log(recoil_time_s(energy_at_rest, 0.25));
  const SharePosterior posterior(
      energy_at_rest, {{usual - 1, usual - 0.01, usual, usual + 0.01, usual + 1}, {1e6, 50, 0, 50, 1e6}});
  CHECK(posterior.limits95().low == Approx(0.25).epsilon(0.01));
  CHECK(posterior.limits95().high == Approx(0.25).epsilon(0.01));
}
