#pragma once

#include "problem/objective.hpp"

namespace trunk {

/// The standard model of respiratory mechanics, for comparison: one compartment of resistance R and elastance
/// E, driven by the same activation A: R dV/dt + E V = P_max A(t), V(0) = 0. Volume alone determines only
/// P_max/R and E/R.
struct OneCompartment {
  double drive = 0.0;         // P_max / R, m3/s
  double rate = 0.0;          // E / R, 1/s
  double residual_sum = 0.0;  // sum of squares, m6
  Eigen::VectorXd residuals;  // [samples] m3, model minus measured
};

/// Returns the least-squares fit of drive and rate. The drive enters linearly; a golden-section search finds
/// the rate between 0.05 and 50 per second. `curve` must hold times.
OneCompartment fit_one_compartment(const MeasuredCurve& curve, const BreathActivation<double>& activation);

/// Returns `start` with the rise, fast fall and slow fall with which a one-compartment model follows the
/// curve best; the rate is free too. The level after the fast fall stays. `curve` must hold times.
BreathActivation<double> timed_by_one_compartment(const MeasuredCurve& curve,
                                                  const BreathActivation<double>& start);

}  // namespace trunk
