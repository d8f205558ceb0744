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
  const auto volume =
      compartment_breath(compartment.of(c.parameters), c.activation, grid, measured.time_s).delta_v;
  return *std::max_element(volume.begin(), volume.end());
}

double muscle_against_recoil(const TrunkAsCompartment& compartment, const Candidate& c, const TimeGrid& grid,
                             const MeasuredCurve& measured) {
  const CompartmentBreath breath =
      compartment_breath(compartment.of(c.parameters), c.activation, grid, measured.time_s);
  const double highest = *std::max_element(breath.delta_v.begin(), breath.delta_v.end());
  return (highest + breath.above_relaxation_m3) / compartment.held_m3;
}

}  // namespace trunk
