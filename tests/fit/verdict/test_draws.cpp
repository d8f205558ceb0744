// Draws of the posterior: do they have the spread that the fit reports?

#include "verdict/draws.hpp"

#include <algorithm>
#include <cmath>

#include "compartment/compartment_model.hpp"
#include "expiration/energy_law.hpp"
#include "support/catch.hpp"

using namespace trunk;
using Catch::Matchers::WithinAbs, Catch::Matchers::WithinRel;

namespace {

/// A breath of 0.5 l that one compartment with a recoil time of 0.5 s lets out from 0.5 l above rest: the
/// squared flow is V^2/(2 tau), and no flow is left.
ExpiredEnergy passive_breath() {
  return {0.25e-6 / (2.0 * 0.5), 0.0, 5.0, 5e-4};
}

SearchSpace stiffness_space() {
  Candidate start;
  start.parameters = {4000.0, 24.0, 20.0, 1.0};
  return SearchSpace({"k_elasticity", "k_muscle"}, start);
}

double percentile(std::vector<double> values, double part) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(part * static_cast<double>(values.size()))];
}

/// The logarithm of a reading in each draw.
template <class Of>
std::vector<double> logs(const std::vector<Candidate>& draws, Of of) {
  std::vector<double> values;
  for (const Candidate& c : draws) values.push_back(std::log(of(c.parameters)));
  return values;
}

}  // namespace

TEST_CASE("Draws of stiffness have the spread of Student's t and of the volume's gain", "[unit]") {
  const SearchSpace space = stiffness_space();
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(2, 2);
  covariance(0, 0) = 0.04;
  covariance(1, 1) = 0.0001;
  const Eigen::VectorXd x = space.start();
  const auto draws = posterior_draws({x, covariance, 5.0, 0.03}, space, 4000, 7);
  const auto elasticity = logs(draws, [](const auto& p) { return p.elasticity; });
  // 2.571 is the 97.5 % point of Student's t with 5 degrees of freedom (tables).
  CHECK_THAT(percentile(elasticity, 0.975) - std::log(4000.0), Catch::Matchers::WithinRel(0.2 * 2.571, 0.03));
  CHECK_THAT(percentile(elasticity, 0.025) - std::log(4000.0),
             Catch::Matchers::WithinRel(-0.2 * 2.571, 0.03));
  const auto ratio = logs(draws, [](const auto& p) { return p.muscle / p.elasticity; });
  double squares = 0.0;
  for (const double r : ratio) squares += std::pow(r - std::log(24.0 / 4000.0), 2) / 4000.0;
  // Student's t with 5 degrees of freedom has the variance 5/3.
  CHECK_THAT(squares, Catch::Matchers::WithinRel(0.0001 * 5.0 / 3.0 + 0.03 * 0.03, 0.05));
}

TEST_CASE("Draws of the recoil time have the energy law's interval, and all else follows", "[unit]") {
  const SearchSpace space = stiffness_space();
  const double relaxation = 25.0, log_error = 0.1;
  const auto time_of = [&](const Parameters<double>& p) { return relaxation * p.damping / p.elasticity; };
  const Eigen::VectorXd best = space.start();
  const auto at = [&](double recoil_s) {
    Eigen::VectorXd x = best;
    const double moved = std::log(recoil_s / 0.125);
    x[0] -= moved;        // k_elasticity
    x[1] += 0.5 * moved;  // the ratio
    return std::pair(std::log(recoil_s), x);
  };
  const ExpiredEnergy energy = passive_breath();
  const ShareLimits share = share_limits95();
  const double low = recoil_time_s(energy, share.low), high = recoil_time_s(energy, share.high);
  const Eigen::MatrixXd none = Eigen::MatrixXd::Zero(2, 2);
  const AlongRecoil along{energy,
                          SharePosterior(energy),
                          log_error,
                          11.0,
                          {at(low / 1.5), at(recoil_time_s(energy, 0.4)), at(high * 1.5)}};
  const auto draws = posterior_draws({best, none, 11.0, 0.0, along}, space, 4000, 7);
  // A share of 1 would need the true time of 0.5 s: the law takes 0.40 of it, 0.20 s.
  const auto time = logs(draws, time_of);
  CHECK_THAT(std::exp(percentile(time, 0.5)), Catch::Matchers::WithinRel(0.2, 0.02));
  const double spread = std::hypot(log_error * 2.201, 1.96 * TrunkAsCompartment::log_error);  // t of 11
  const auto reach = [&](double limit) { return std::hypot(std::log(limit / 0.2), spread); };
  CHECK_THAT(std::log(0.2) - percentile(time, 0.025), Catch::Matchers::WithinRel(reach(low), 0.1));
  CHECK_THAT(percentile(time, 0.975) - std::log(0.2), Catch::Matchers::WithinRel(reach(high), 0.1));
  for (const Candidate& c : draws) {
    const double ratio = c.parameters.muscle / c.parameters.elasticity;
    CHECK_THAT(std::log(ratio / (24.0 / 4000.0)),
               Catch::Matchers::WithinAbs(0.5 * std::log(time_of(c.parameters) / 0.125), 1e-9));
  }
}

TEST_CASE("A recoil time without a limit ends a tenth beyond the longest that was fitted", "[unit]") {
  const SearchSpace space = stiffness_space();
  const Eigen::VectorXd best = space.start();
  Eigen::VectorXd softer = best;
  softer[0] -= std::log(2.0);
  ExpiredEnergy energy = passive_breath();
  energy.late_flow_m3_s =
      2.0 * energy.squared_flow / energy.tidal_volume_m3;  // f above 0.5 has no recoil time
  const AlongRecoil along{
      energy, SharePosterior(energy), 0.0, 11.0, {{std::log(0.125), best}, {std::log(0.25), softer}}};
  const auto draws = posterior_draws({best, Eigen::MatrixXd::Zero(2, 2), 11.0, 0.0, along}, space, 256, 7);
  const auto elasticity = logs(draws, [](const auto& p) { return p.elasticity; });
  CHECK_THAT(*std::min_element(elasticity.begin(), elasticity.end()),
             Catch::Matchers::WithinAbs(std::log(4000.0) - 1.1 * std::log(2.0), 1e-9));
}
