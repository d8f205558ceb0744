#include "estimation/quality.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compartment/one_compartment.hpp"
#include "uncertainty/noise.hpp"

namespace trunk {

Quality quality_of(const MeasuredCurve& curve, const Eigen::VectorXd& model, std::size_t parameters,
                   const TimeGrid& grid, const BreathActivation<double>& activation) {
  Quality q;
  const Eigen::VectorXd measured = Eigen::VectorXd::Map(curve.delta_v.data(), model.size());
  q.tidal_volume_m3 = curve.tidal_volume();
  const auto normalised = [&](const Eigen::VectorXd& residuals) {
    return std::sqrt(residuals.squaredNorm() / static_cast<double>(residuals.size())) / q.tidal_volume_m3;
  };
  q.nrmse = normalised(model - measured);
  q.tidal_volume_error_m3 = model.maxCoeff() - q.tidal_volume_m3;
  if (curve.is_tidal_volume()) return q;
  Eigen::Index model_peak = 0, measured_peak = 0;
  model.maxCoeff(&model_peak);
  measured.maxCoeff(&measured_peak);
  q.peak_time_error_s = curve.time_s[static_cast<std::size_t>(model_peak)] -
                        curve.time_s[static_cast<std::size_t>(measured_peak)];
  const OneCompartment baseline = fit_one_compartment(curve, activation, grid);
  q.baseline_nrmse = normalised(baseline.residuals);
  q.baseline = measured + baseline.residuals;
  q.bic = ar1_bic((model - measured) / q.tidal_volume_m3, parameters);
  q.baseline_bic = ar1_bic(baseline.residuals / q.tidal_volume_m3, parameters);
  return q;
}

std::string caveat(const Quality& q) {
  const double usual = 0.05;
  if (q.baseline_nrmse <= 0.0 || q.nrmse < std::max(usual, 2.0 * q.baseline_nrmse)) return "";
  return fmt::format(
      " The model follows this breath poorly: its residual is {:.1f} % of tidal volume, and that of a "
      "one-compartment model is {:.1f} %. So its parameters are less certain than their intervals.",
      100.0 * q.nrmse, 100.0 * q.baseline_nrmse);
}

}  // namespace trunk
