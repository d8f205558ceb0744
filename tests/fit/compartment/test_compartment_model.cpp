#include "compartment/compartment_model.hpp"

#include "anatomy/breath_run.hpp"
#include "dynamics/recoil.hpp"
#include "support/catch.hpp"
#include "support/trunks.hpp"

#include <cmath>

using namespace trunk;
using namespace trunk::test;

TEST_CASE("One compartment breathes like a trunk with a lung", "[compartment]") {
  for (const double resistance : {1.0, 5.0}) {
    Scenario s = breathing_air();
    s.time = {5e-3, 4.5, Damping::centred, Start::periodic};
    s.parameters.resistance = resistance * Pa_per_cmH2O / m3_per_litre;
    const Trunk trunk = make_trunk(s);
    const Parameters<double>& p = s.parameters;
    const TrunkAsCompartment compartment = as_compartment(measure_recoil(trunk.model, p), trunk.model.pleura);
    const VolumeCurve curve = simulate_volume(trunk, p, s.activation, s.time);
    std::vector<double> time_s;
    for (std::size_t n = 0; n < curve.delta_v.size(); ++n)
      time_s.push_back(static_cast<double>(n) * s.time.dt_s);
    const CompartmentBreath breath = compartment_breath(compartment.of(p), s.activation, s.time, time_s);
    double squares = 0.0, highest = 0.0;
    for (std::size_t n = 0; n < time_s.size(); ++n) {
      squares += std::pow(breath.delta_v[n] - curve.delta_v[n], 2);
      highest = std::max(highest, curve.delta_v[n]);
    }
    const double nrmse = std::sqrt(squares / static_cast<double>(time_s.size())) / highest;
    CAPTURE(resistance, nrmse);
    CHECK(nrmse < 0.02);
    CHECK(breath.above_relaxation_m3 == Approx(curve.above_relaxation).margin(0.02 * highest));
  }
}

TEST_CASE("A compartment that a muscle holds still has the pressures of its springs", "[compartment]") {
  // V = 0.4 l is held: the lung pulls with E_L V, the abdomen pushes with E_ab V, and the dome has come down.
  const Parameters<double> p{2000.0, 20.0, 15.0, 0.3, 5.0 * Pa_per_cmH2O / m3_per_litre, 2e5};
  TrunkAsCompartment trunk{24.0, 0.05, 0.05, 25.0, 500.0, 1e5};
  trunk.abdominal = 300.0;
  trunk.abdominal_flow = 2e3;
  trunk.right_descent = 20.0;
  TimeGrid grid{1e-3, 60.0};
  BreathActivation<double> full{
      .rise_s = 1.0, .fast_fall_s = 100.0, .slow_fall_s = 1.0, .fast_fall_level = 1.0};
  const MeasuredCurve measured{{0.0, 60.0}, {0.0, 0.0}, {}, {{ChannelKind::pleural, {0.0, 0.0}, 1.0}}};
  const SeenBreath seen_at = seen(trunk, {p, full}, grid, measured);
  const double held = seen_at.delta_v[1];
  CHECK(held == Approx(trunk.of(p).gain_m3));
  CHECK(seen_at.pleural_Pa[1] == Approx(-p.lung_elastance * held));
  CHECK(seen_at.abdominal_Pa[1] == Approx(300.0 * 2000.0 * held));
  CHECK(seen_at.right_dome_m[1] == Approx(-20.0 * held));
}

TEST_CASE("A compartment that flows has the pressures of its resistances", "[compartment]") {
  // As a full muscle begins to pull, V = 0 and V' = gain / tau, and no spring has moved yet: what differs
  // from the time before is (R + R_tube) V' and the drag of the abdomen.
  const Parameters<double> p{2000.0, 20.0, 15.0, 0.3, 5.0 * Pa_per_cmH2O / m3_per_litre, 2e5};
  TrunkAsCompartment trunk{24.0, 0.05, 0.05, 25.0, 500.0, 1e5};
  trunk.abdominal_flow = 2e3;
  TimeGrid grid{1e-3, 10.0};
  constexpr double at_once_s = 1e-6;
  BreathActivation<double> sudden{
      .onset_s = 1.0, .rise_s = at_once_s, .fast_fall_s = 100.0, .slow_fall_s = 1.0, .fast_fall_level = 1.0};
  const MeasuredCurve measured{
      {0.0, 1.0 + 2.0 * at_once_s}, {0.0, 0.0}, {}, {{ChannelKind::pleural, {0.0, 0.0}, 1.0}}};
  const SeenBreath begin = seen(trunk, {p, sudden}, grid, measured);
  const Compartment c = trunk.of(p);
  const double flow = c.gain_m3 / c.time_constant_s;
  CHECK(begin.pleural_Pa[1] == Approx(-(2e5 + 1e5) * flow).epsilon(1e-4));
  CHECK(begin.abdominal_Pa[1] == Approx(2e3 * 15.0 * flow).epsilon(1e-4));
}

TEST_CASE("The stiffness of a recoil time, and a trunk moved to other parameters", "[compartment]") {
  const Parameters<double> p{1900.0, 20.0, 15.0, 0.3, 5e5, 2e5}, found{2300.0, 17.0, 12.0, 0.3, 4e5, 3e5};
  for (const double elastance : {0.0, 500.0}) {
    const TrunkAsCompartment trunk{24.0, 0.07, 0.07, 25.0, elastance, 1e5};
    Parameters<double> there = p;
    there.elasticity = trunk.elasticity_of(0.4, p);
    CHECK(trunk.recoil_time_s(there) == Approx(0.4));
    // Of the damping, only that of `p` counts where there is no lung: a fit of volume alone does not change
    // it.
    Parameters<double> as_found = found;
    as_found.damping = p.damping;
    const TrunkAsCompartment moved = trunk.moved(as_found, p);
    CHECK(moved.time_constant_s(p) == Approx(trunk.time_constant_s(as_found)));
    CHECK(moved.of(p).gain_m3 == Approx(trunk.of(as_found).gain_m3));
  }
}
