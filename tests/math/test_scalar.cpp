#include <cmath>

#include "support/catch.hpp"
#include "support/trunks.hpp"

using namespace trunk;
using namespace trunk::test;

namespace {

/// Returns all positions at the end of a breath that is simulated in another scalar, as double.
template <Scalar S>
std::vector<Vec3d> positions_after(const Scenario& scenario, int steps) {
  const auto& p = scenario.parameters;
  const auto& a = scenario.activation;
  const Parameters<S> parameters{S(p.elasticity), S(p.muscle), S(p.damping), S(p.abdomen_factor)};
  const BreathActivation<S> activation{S(a.onset_s),     S(a.rise_s),          S(a.fast_fall_s),
                                       S(a.slow_fall_s), S(a.fast_fall_level), S(a.period_s)};
  const Trunk trunk = make_trunk(scenario);
  std::vector<Vec3d> result;
  const Ending ending =
      simulate(trunk.model, parameters, activation, {1e-3, steps * 1e-3},
               [&](int, S, const State<S>& state, const StepReport<S>&) {
                 result.clear();
                 for (const Vec3<S>& x : state.position)
                   result.emplace_back(static_cast<double>(x.x()), static_cast<double>(x.y()),
                                       static_cast<double>(x.z()));
               });
  REQUIRE(ending.completed());
  return result;
}

}  // namespace

TEST_CASE("The kernel in long double agrees with double to round-off", "[property][dynamics][slow]") {
  // This shows that the kernel takes any scalar, and it bounds the round-off of double.
  for (const char* name : {"healthy", "hemiparalysis_right", "published_healthy"}) {
    Scenario scenario = shipped(name);
    scenario.activation.rise_s = 0.3;  // so that much moves in few steps
    const auto in_double = positions_after<double>(scenario, 500);
    const auto in_long_double = positions_after<long double>(scenario, 500);
    const double moved = largest(difference(in_double, make_trunk(scenario).model.rest));
    const double apart = largest(difference(in_double, in_long_double));
    INFO(name);
    CAPTURE(moved, apart);
    REQUIRE(moved > 1e-3);
    CHECK(apart < 1e-12);
    CHECK(apart > 0.0);  // the scalar was not double
    WARN(name << ": after 500 steps long double and double are " << apart << " m apart, " << moved
              << " m moved");
  }
}
