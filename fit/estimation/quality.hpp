#pragma once

#include "problem/objective.hpp"

namespace trunk {

/// How well the fitted curve follows the measured one, compared with a one-compartment model.
struct Quality {
  double tidal_volume_m3 = 0.0;        // measured
  double nrmse = 0.0;                  // RMS residual over tidal volume
  double tidal_volume_error_m3 = 0.0;  // model minus measured
  double peak_time_error_s = 0.0;      // model minus measured
  double bic = 0.0;                    // AR(1) noise
  double baseline_nrmse = 0.0;         // of the one-compartment model
  double baseline_bic = 0.0;
  Eigen::VectorXd
      baseline;  // [samples] m3, the one-compartment model; empty if only a tidal volume was fitted
};

/// Returns the quality of `model` [samples] m3, which a fit of `parameters` numbers gave. The one-compartment
/// model has the activation and the grid of the fit, so both count the same parameters.
Quality quality_of(const MeasuredCurve& curve, const Eigen::VectorXd& model, std::size_t parameters,
                   const TimeGrid& grid, const BreathActivation<double>& activation);

/// Returns a warning if the model misses the breath, however narrow its intervals are; otherwise "".
std::string caveat(const Quality& quality);

}  // namespace trunk
