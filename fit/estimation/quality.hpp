#pragma once

#include "problem/objective.hpp"

namespace trunk {

/// How well a fitted curve meets the measured one, and beside it the model every physiologist knows.
struct Quality {
  double tidal_volume_m3 = 0.0;        // measured
  double nrmse = 0.0;                  // RMS residual over tidal volume
  double tidal_volume_error_m3 = 0.0;  // model minus measured
  double peak_time_error_s = 0.0;      // model minus measured
  double bic = 0.0;                    // AR(1) noise
  double baseline_nrmse = 0.0;         // of the one-compartment model
  double baseline_bic = 0.0;
  Eigen::VectorXd baseline;  // [samples] m3, the one-compartment model; empty without a curve
};

/// `model` at the measured samples, m3, from a fit of `parameters` numbers. The one-compartment model has the
/// activation `given` to the fit, of which `timed` numbers were taken from the trace.
Quality quality_of(const MeasuredCurve& curve, const Eigen::VectorXd& model, std::size_t parameters,
                   const BreathActivation<double>& given, std::size_t timed);

/// A sentence where the model misses the breath however narrow its intervals; else "".
std::string caveat(const Quality& quality, double residual_autocorrelation);

}  // namespace trunk
