#include "compartment/compartment_model.hpp"

#include "anatomy/breath_run.hpp"
#include "dynamics/recoil.hpp"
#include "support/catch.hpp"
#include "support/trunks.hpp"

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
