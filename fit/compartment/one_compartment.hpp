#pragma once

#include "problem/objective.hpp"

namespace trunk {

/// The model every physiologist knows, fitted beside ours: one compartment of resistance R and elastance E
/// driven by the same activation, R dV/dt + E V = P_max A(t), V(0) = 0. Volume alone determines P_max/R and
/// E/R.
struct OneCompartment {
  double drive = 0.0;         // P_max / R, m3/s
  double rate = 0.0;          // E / R, 1/s
  double residual_sum = 0.0;  // sum of squares, m6
  Eigen::VectorXd residuals;  // [samples] m3, model minus measured
};

/// Least squares over both numbers: the drive enters linearly, the rate is found by a golden section over
/// 0.05 to 50 per second. `curve` must be a curve.
OneCompartment fit_one_compartment(const MeasuredCurve& curve, const BreathActivation<double>& activation);

/// The activation whose rise, fast and slow fall let a one-compartment model follow the curve best, all
/// three and the rate free, from `start`. The level after the fast fall stays. `curve` must be a curve.
BreathActivation<double> timed_by_one_compartment(const MeasuredCurve& curve,
                                                  const BreathActivation<double>& start);

}  // namespace trunk
