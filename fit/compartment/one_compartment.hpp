#pragma once

#include "compartment/compartment_breath.hpp"
#include "problem/measured_curve.hpp"

namespace trunk {

/// The standard model of respiratory mechanics, for comparison: one compartment of resistance R and elastance
/// E, driven by an activation A: R dV/dt + E V = P_max A(t). Volume alone determines only P_max/E and R/E.
struct OneCompartment {
  Compartment compartment;
  double residual_sum = 0.0;  // sum of squares, m6
  Eigen::VectorXd residuals;  // [samples] m3, model minus measured
};

/// Returns the least-squares fit of time constant and gain, which begins as the grid says: at rest, or in
/// breathing that repeats. The gain enters linearly; a golden-section search finds the time constant between
/// 0.02 and 20 s. `curve` must hold times.
OneCompartment fit_one_compartment(const MeasuredCurve& curve, const BreathActivation<double>& activation,
                                   const TimeGrid& grid);

}  // namespace trunk
