#include "dynamics/simulate.hpp"

#include <fmt/format.h>

namespace trunk {

Ending make_ending(Ending::Status status, int step, double time_s) {
  const auto message = [&]() -> std::string {
    switch (status) {
      case Ending::Status::volume_lost:
        return fmt::format(
            "the abdominal volume could not be held at {:.4f} s: the step is too long or the forces too "
            "strong",
            time_s);
      case Ending::Status::diverged:
        return fmt::format(
            "a particle moved farther than the trunk is tall before {:.4f} s: the simulation diverged",
            time_s);
      case Ending::Status::completed:
        return "completed";
      case Ending::Status::unset:
        break;
    }
    return Ending{}.message;
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
