#pragma once

#include <span>
#include <vector>

#include "activation/breath_activation.hpp"
#include "dynamics/simulate.hpp"

namespace trunk {

/// One compartment that a muscle drives: tau dV/dt + V = gain A(t), with V above relaxation.
struct Compartment {
  double time_constant_s = 0.0;  // tau
  double gain_m3 = 0.0;          // volume that full activation holds
};

/// Volume of a compartment over one breath.
struct CompartmentBreath {
  std::vector<double> delta_v;       // [times] m3 above the volume at time 0
  double above_relaxation_m3 = 0.0;  // the volume at time 0
};

/// Returns the exact volume at `time_s` [times], increasing within 0 to the grid's duration. The activation
/// consists of straight lines, and between its knots the solution is an exponential and a line. A periodic
/// grid repeats the breath for ever: the phase of the activation wraps at its onset, so the next breath cuts
/// what is left of the last one. A grid that starts at rest begins with V = 0.
CompartmentBreath compartment_breath(const Compartment& compartment,
                                     const BreathActivation<double>& activation, const TimeGrid& grid,
                                     std::span<const double> time_s);

/// Returns the same of a compartment of gain 1 that follows `held` [times], m3, instead of a muscle. It is
/// straight between the times, which increase from 0 to the grid's duration.
CompartmentBreath driven_breath(double time_constant_s, const std::vector<double>& held, const TimeGrid& grid,
                                std::span<const double> time_s);

}  // namespace trunk
