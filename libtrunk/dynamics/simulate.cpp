#include "dynamics/simulate.hpp"

#include <fmt/format.h>

namespace trunk {

Summary ended(Summary::Status status, int step, double time_s) {
  const auto message = [&]() -> std::string {
    switch (status) {
      case Summary::Status::volume_lost:
        return fmt::format(
            "the abdominal volume could not be held at {:.4f} s: the step is too long or the forces too "
            "strong",
            time_s);
      case Summary::Status::diverged:
        return fmt::format(
            "a particle moved farther than the trunk is tall before {:.4f} s: the simulation diverged",
            time_s);
      case Summary::Status::completed:
        return "completed";
      case Summary::Status::unset:
        break;
    }
    return Summary{}.message;
  };
  return {status, step, time_s, message()};
}

double height(const Model& model) {
  double low = model.rest.front().z(), high = low;
  for (const Vec3d& p : model.rest) {
    low = std::min(low, p.z());
    high = std::max(high, p.z());
  }
  return high - low;
}

}  // namespace trunk
