#include "estimation/start.hpp"

#include <algorithm>
#include <cmath>

namespace trunk {

Eigen::VectorXd start_at_tidal_volume(Objective& objective, const Eigen::VectorXd& start) {
  const SearchSpace& space = objective.space();
  const auto& measured = objective.target().delta_v;
  const auto peak = std::max_element(measured.begin(), measured.end());
  if (*peak <= 0.0) return start;
  const Eigen::Index at_peak = peak - measured.begin();
  for (std::size_t i = 0; i < space.size(); ++i) {
    if (!space.is_ratio(i)) continue;
    const auto ratio = static_cast<Eigen::Index>(i);
    const double lowest = space.lower()[ratio], highest = space.upper()[ratio];
    Eigen::VectorXd x = start;
    for (int steps = 0; steps < 8; ++steps) {
      const auto residuals = objective.residuals(x);
      const double model = residuals ? (*residuals)[at_peak] + *peak : 4.0 * *peak;  // failed: far too strong
      if (std::abs(model / *peak - 1.0) < 0.02) return x;
      // The volume grows about as the ratio does.
      x[ratio] = std::clamp(x[ratio] + std::log(*peak / std::max(model, 0.02 * *peak)), lowest, highest);
    }
    return x;
  }
  return start;
}

}  // namespace trunk
