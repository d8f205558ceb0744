#include <algorithm>
#include <cmath>

#include "math/units.hpp"
#include "verdict/groups_of_results.hpp"
#include "verdict/reasons.hpp"

namespace trunk {
namespace {

/// A measure of the trunk, in the unit of its result.
using Measured = double (*)(const Measures&);

/// Simulates the points of a fit, and one with more muscle: it shows how measures go with the volume.
class SimulatedPoints {
 public:
  explicit SimulatedPoints(const FitPoints& points) : points_(points) {
    constexpr double more_muscle = 1.05;
    const FitProblem& p = points.evidence().problem;
    Candidate stronger = points.best();
    stronger.parameters.muscle *= more_muscle;
    const std::vector<Candidate> all = {points.best(), points.low_recoil(), points.high_recoil(), stronger};
    breaths_ = summarise_breaths(p.trunk, all, p.grid);
    const Reading volume = [&](const Candidate& x) {
      return std::log(tidal_volume(p.compartment, x, p.grid, p.measured));
    };
    volume_deviation_ = points.deviation(volume);
  }

  bool completed() const { return breaths_.front().ending.completed(); }

  FitResult result(const char* name, Measured measured) const {
    const auto at = [&](std::size_t i) {
      return breaths_[i].ending.completed() ? measured(breaths_[i].measures)
                                            : std::numeric_limits<double>::quiet_NaN();
    };
    const double by_volume =
        (at(3) - at(0)) / std::log(breaths_[3].measures.delta_v / breaths_[0].measures.delta_v);
    const Readings r{at(0), at(1), at(2), std::abs(by_volume) * volume_deviation_, false};
    FitResult out = points_.result(name, "mm", r, false);
    const double gain = normal_quantile * points_.volume_error() * std::abs(by_volume);
    out.lower95 = out.value - std::hypot(out.value - out.lower95, gain);
    out.upper95 = out.value + std::hypot(out.upper95 - out.value, gain);
    out.assumption = "the subject's trunk has the shape of the model's";
    return out;
  }

 private:
  const FitPoints& points_;
  std::vector<BreathSummary> breaths_;  // best point, both ends of the recoil time, more muscle
  double volume_deviation_ = 0.0;       // of its logarithm
};

FitResult above_relaxation_result(const FitPoints& points) {
  const FitProblem& p = points.evidence().problem;
  const Readings above_ml = points.read(
      [&](const Candidate& x) { return ml_per_m3 * above_relaxation(p.compartment, x, p.grid, p.measured); },
      false);
  FitResult above = points.result("end_expiratory_above_relaxation_ml", "ml", above_ml, true);
  if (!points.evidence().airway_driven) above.lower95 = std::max(above.lower95, 0.0);
  above.assumption = course_assumption(points.evidence());
  points.grade(above, course_reason(points.evidence(), points.recoil()));
  return above;
}

}  // namespace

std::vector<FitResult> measure_results(const FitPoints& points) {
  const SimulatedPoints simulated(points);
  if (!simulated.completed()) return {};
  return {
      simulated.result("excursion_right_mm", [](const Measures& m) { return mm_per_m * m.excursion_right; }),
      simulated.result("excursion_left_mm", [](const Measures& m) { return mm_per_m * m.excursion_left; }),
      simulated.result("delta_l_mm", [](const Measures& m) { return mm_per_m * m.delta_l; }),
      simulated.result("delta_h_mm", [](const Measures& m) { return mm_per_m * m.delta_h; }),
      above_relaxation_result(points)};
}

}  // namespace trunk
