#include <cmath>
#include <numeric>
#include <vector>

#include "structure/mixture.hpp"
#include "support/catch.hpp"

using namespace trunk;

namespace {

Mixture mixture(const std::vector<Effect>& effects, const std::vector<Crossing>& crossings = {}) {
  return mixture_of(effects, crossings);
}

}  // namespace

TEST_CASE("One linear effect spreads evenly between its ends", "[structure]") {
  const Mixture m = mixture({{-2.0, 2.0}});
  CHECK(m.lower95 == Approx(-1.9).epsilon(2e-3));  // 95 % of a uniform number from -2 to 2
  CHECK(m.upper95 == Approx(1.9).epsilon(2e-3));
  CHECK(m.shares == std::vector<double>{1.0});
}

TEST_CASE("An effect that bends has the percentiles of a square", "[structure]") {
  const Mixture m = mixture({{1.0, 1.0}});  // u^2
  CHECK(m.lower95 == Approx(0.025 * 0.025).margin(2e-4));
  CHECK(m.upper95 == Approx(0.975 * 0.975).epsilon(2e-3));
}

TEST_CASE("Many equal effects come to a normal distribution", "[structure]") {
  const Mixture m = mixture(std::vector<Effect>(12, {-1.0, 1.0}));  // variance 12 / 3
  CHECK(m.upper95 == Approx(1.96 * 2.0).epsilon(0.02));
  CHECK(m.lower95 == Approx(-1.96 * 2.0).epsilon(0.02));
}

TEST_CASE("Shares add to one and go with the variance", "[structure]") {
  const Mixture m = mixture({{-1.0, 1.0}, {-2.0, 2.0}, {0.0, 3.0, true}});
  CHECK(std::accumulate(m.shares.begin(), m.shares.end(), 0.0) == Approx(1.0));
  CHECK(m.shares[1] == Approx(4.0 * m.shares[0]));
  CHECK(m.shares[2] == Approx(m.shares[0] * (9.0 / 4.0) / (1.0 / 3.0)));  // 0 or 3, each half of the time
}

TEST_CASE("Two choices that only act together share the variance of their product", "[structure]") {
  const Mixture m = mixture({{0.0, 0.0}, {0.0, 0.0}, {-1.0, 1.0}}, {{0, 1, 3.0}});
  CHECK(m.shares[0] == Approx(0.5 / (1.0 + 1.0 / 3.0)));  // E u^2 v^2 = 1/9
  CHECK(m.shares[1] == Approx(m.shares[0]));
  CHECK(m.shares[0] + m.shares[1] + m.shares[2] == Approx(1.0));
  const Mixture alone = mixture({{0.0, 0.0}, {0.0, 0.0}}, {{0, 1, 1.0}});
  // The product p of two uniform numbers has P(|p| < q) = q (1 - ln q); 0.95 at q = 0.7009.
  CHECK(alone.upper95 == Approx(0.7009).epsilon(0.01));
  CHECK(alone.lower95 == Approx(-0.7009).epsilon(0.01));
}

TEST_CASE("What changes nothing has no width, and what is not known makes all unknown", "[structure]") {
  const Mixture still = mixture({{0.0, 0.0}, {0.0, 0.0, true}});
  CHECK(still.lower95 == 0.0);
  CHECK(still.upper95 == 0.0);
  CHECK(std::isnan(still.shares[0]));
  CHECK(mixture({}).upper95 == 0.0);
  CHECK(std::isnan(mixture({{-1.0, 1.0}, {std::nan(""), 1.0}}).upper95));
}
