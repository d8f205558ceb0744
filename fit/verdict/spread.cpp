#include "verdict/spread.hpp"

#include <algorithm>
#include <cmath>

namespace trunk {

Eigen::VectorXd gradient_of(const Reading& reading, const SearchSpace& space, const Eigen::VectorXd& x) {
  const double step = 1e-3;
  Eigen::VectorXd gradient(x.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const Eigen::VectorXd aside = step * Eigen::VectorXd::Unit(x.size(), i);
    gradient[i] = (reading(space.decode(x + aside)) - reading(space.decode(x - aside))) / (2.0 * step);
  }
  return gradient;
}

double deviation_of(const Eigen::VectorXd& gradient, const Eigen::MatrixXd& covariance) {
  return std::sqrt(std::max(gradient.dot(covariance * gradient), 0.0));
}

double tidal_volume(const TrunkAsCompartment& compartment, const Candidate& c, const TimeGrid& grid,
                    const MeasuredCurve& measured) {
  const auto volume = breath_of(compartment, c, grid, measured.time_s).delta_v;
  return *std::max_element(volume.begin(), volume.end());
}

double above_relaxation(const TrunkAsCompartment& compartment, const Candidate& c, const TimeGrid& grid,
                        const MeasuredCurve& measured) {
  std::span<const double> time_s;  // what a muscle does needs none
  if (!compartment.airway_pressure.empty()) time_s = measured.time_s;
  return breath_of(compartment, c, grid, time_s).above_relaxation_m3;
}

double muscle_against_recoil(const TrunkAsCompartment& compartment, const Candidate& c, const TimeGrid& grid,
                             const MeasuredCurve& measured) {
  const CompartmentBreath breath = breath_of(compartment, c, grid, measured.time_s);
  const auto highest = std::max_element(breath.delta_v.begin(), breath.delta_v.end());
  double held_m3 = *highest + breath.above_relaxation_m3;
  if (!compartment.airway_pressure.empty()) {  // the airway holds a part
    const auto at = static_cast<std::size_t>(highest - breath.delta_v.begin());
    held_m3 -=
        compartment.airway_pressure(measured.time_s[at]) / compartment.respiratory_elastance(c.parameters);
  }
  return held_m3 / compartment.held(c.parameters);
}

}  // namespace trunk
