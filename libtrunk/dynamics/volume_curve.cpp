#include "dynamics/volume_curve.hpp"

#include <fmt/format.h>

#include "math/units.hpp"

namespace trunk {

void require_lung(double lowest_volume, Ending& ending) {
  if (!ending.completed() || lowest_volume > 0.0) return;
  ending.status = Ending::Status::diverged;
  ending.message = fmt::format(
      "the lung lost all of its volume (lowest: {:.0f} ml): the loads or movements are more than this "
      "model can follow",
      ml_per_m3 * lowest_volume);
}

double take_first_off(std::vector<double>& values) {
  const double first = values.empty() ? 0.0 : values.front();
  for (double& value : values) value -= first;
  return first;
}

}  // namespace trunk
