#include "dynamics/volume_curve.hpp"

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

LungGain::LungGain(const Model& model)
    : moving_(by_motion(model.lung_fans, model).moving),
      start_(volume_of_fans<double>(moving_, model.rest)) {}

void require_lung(double lowest_volume, Summary& summary) {
  if (!summary.completed() || lowest_volume > 0.0) return;
  summary.status = Summary::Status::diverged;
  summary.message = fmt::format(
      "the lung lost all of its volume (lowest: {:.0f} ml): the loads or movements are more than this "
      "model can follow",
      1e6 * lowest_volume);
}

void require_lung(double start_volume, VolumeCurve& curve) {
  require_lung(start_volume + *std::min_element(curve.delta_v.begin(), curve.delta_v.end()), curve.summary);
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
