#include "dynamics/simulate.hpp"

namespace trunk {

double height(const Model& model) {
  double low = model.rest.front().z(), high = low;
  for (const Vec3d& p : model.rest) {
    low = std::min(low, p.z());
    high = std::max(high, p.z());
  }
  return high - low;
}

}  // namespace trunk
