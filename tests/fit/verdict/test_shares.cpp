#include "verdict/shares.hpp"

#include <Eigen/LU>
#include <cmath>

#include "support/catch.hpp"
#include "support/trunk_objective.hpp"
#include "support/trunks.hpp"

using namespace trunk;

namespace {

double part_of(const std::vector<Share>& shares, const std::string& source) {
  for (const Share& s : shares)
    if (s.source == source) return s.part;
  return 0.0;
}

}  // namespace

TEST_CASE("Shares are the parts of the information on a result, and add up to 1", "[unit][fit]") {
  const Scenario s = test::breathing_air();
  const Trunk trunk = make_trunk(s);
  MeasuredCurve measured{
      {0.0, 1.0, 2.0}, {0.0, 4e-4, 0.0}, {}, {{ChannelKind::gastric, {0.0, 300.0, 0.0}, 30.0}}};
  const SearchSpace space({"k_elasticity", "lung_elastance"}, {s.parameters, s.activation}, {},
                          {{"lung_elastance", 5.0, 0.4}});
  const TrunkAsCompartment compartment = as_compartment({25.0, 0.07, 30.0, 0.3, 500.0, 260.0}, Pleura{});
  const FitProblem problem{trunk, s.time, space, measured, compartment};

  // Two rows of the volume see the first coordinate, one of the pressure sees it as well, and the prior the
  // other.
  LocalFit fit;
  fit.x = space.start();
  fit.x[1] = std::log(5.0) + 3.2 * 0.4;
  fit.blocks = blocks_of(measured);
  fit.rows = Eigen::MatrixXd::Zero(7, 2);
  fit.rows.col(0) << 1.0, 1.0, 0.0, 0.0, std::sqrt(6.0), 0.0, 0.0;
  fit.rows(6, 1) = 2.5;
  fit.unit_covariance = (fit.rows.transpose() * fit.rows).inverse();
  const auto first = shares_of(problem, fit, Eigen::Vector2d(1.0, 0.0));
  CHECK(part_of(first, "volume") == Approx(0.25));
  CHECK(part_of(first, "gastric pressure") == Approx(0.75));
  CHECK(prior_part(first) == Approx(0.0).margin(1e-12));
  CHECK(first.front().source == "gastric pressure");
  const auto second = shares_of(problem, fit, Eigen::Vector2d(0.0, 3.0));
  CHECK(part_of(second, "prior of lung_elastance") == Approx(1.0));
  CHECK(second.front().pull == Approx(3.2));
  const auto both = shares_of(problem, fit, Eigen::Vector2d(1.0, 1.0));
  double sum = 0.0;
  for (const Share& share : both) sum += share.part;
  CHECK(sum == Approx(1.0));
  // The variances of the two coordinates are 1/8 and 1/6.25.
  CHECK(prior_part(both) == Approx((1.0 / 6.25) / (1.0 / 8.0 + 1.0 / 6.25)));
  CHECK(text_of(first) == "gastric pressure 75 %, volume 25 %");
}

TEST_CASE("Priors of one kind make one share, with the strongest pull among them", "[unit][fit]") {
  const Scenario s = test::breathing_air();
  const Trunk trunk = make_trunk(s);
  const MeasuredCurve measured{{0.0, 1.0}, {0.0, 4e-4}, {}, {}};
  const SearchSpace space({"rise", "slow_fall"}, {s.parameters, s.activation}, {},
                          {{"rise", std::nullopt, 0.2}, {"slow_fall", std::nullopt, 0.2}});
  const TrunkAsCompartment compartment = as_compartment({25.0, 0.07, 30.0, 0.3, 500.0, 260.0}, Pleura{});
  const FitProblem problem{trunk, s.time, space, measured, compartment};
  LocalFit fit;
  fit.x = space.start();
  fit.x[1] -= 4.0 * 0.2;
  fit.blocks = blocks_of(measured);
  fit.rows = Eigen::MatrixXd::Zero(4, 2);
  fit.rows(2, 0) = fit.rows(3, 1) = 5.0;
  fit.unit_covariance = (fit.rows.transpose() * fit.rows).inverse();
  const auto shares = shares_of(problem, fit, Eigen::Vector2d(1.0, 1.0));
  CHECK(part_of(shares, "timing") == Approx(1.0));
  CHECK(shares.front().pull == Approx(4.0));
}
