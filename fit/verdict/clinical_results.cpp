#include <algorithm>
#include <cmath>

#include "math/units.hpp"
#include "verdict/groups_of_results.hpp"
#include "verdict/sentences.hpp"

namespace trunk {
namespace {

constexpr double per_unit = m3_per_litre / Pa_per_cmH2O;

/// Returns the value of a course that is the largest in size, with its sign.
double swing_of(const auto& course) {
  double most = 0.0;
  for (const double v : course)
    if (std::abs(v) > std::abs(most)) most = v;
  return most;
}

FitResult graded(const FitPoints& points, FitResult result) {
  points.grade(result, "");
  return result;
}

FitResult peep_result(const FitPoints& points) {
  const FitProblem& p = points.evidence().problem;
  const TrunkAsCompartment& c = p.compartment;
  const Readings peep = points.read(
      [&](const Candidate& x) {
        const double above_m3 = above_relaxation(c, x, p.grid, p.measured);
        const double recoil_Pa = above_m3 * c.respiratory_elastance(x.parameters);
        return (recoil_Pa - c.airway_pressure(0.0)) / Pa_per_cmH2O;
      },
      false);
  FitResult out = points.result("intrinsic_peep_cmH2O", "cmH2O", peep, false);
  if (!points.evidence().airway_driven) out.lower95 = std::max(out.lower95, 0.0);
  return graded(points, std::move(out));
}

/// The swings are those of the trunk, with the relative spread of the compartment's.
void add_swings(const FitPoints& points, std::vector<FitResult>& all) {
  const FitProblem& p = points.evidence().problem;
  const VolumeCurve curves =
      simulate_volume(p.trunk, points.best().parameters, points.best().activation, p.grid);
  if (!curves.ending.completed()) return;
  const MeasuredCurve seen_at{
      p.measured.time_s, p.measured.delta_v, {}, {{ChannelKind::gastric, {0.0}, 1.0}}};
  using Course = std::function<Eigen::VectorXd(const SeenBreath&)>;
  const auto add_swing = [&](const char* name, const std::vector<double>& simulated, const Course& course) {
    const Readings r = points.read([&](const Candidate& x) {
      return std::abs(swing_of(course(seen(p.compartment, x, p.grid, seen_at)))) / Pa_per_cmH2O;
    });
    const double value = swing_of(simulated) / Pa_per_cmH2O,
                 spread = std::exp(points.quantile() * r.deviation);
    FitResult out{name, "cmH2O", value, value / spread, value * spread, Grade::assumption};
    if (value < 0.0) std::swap(out.lower95, out.upper95);
    out.meaning = meaning_of(name);
    out.shares = r.shares;
    all.push_back(graded(points, std::move(out)));
  };
  add_swing("gastric_swing_cmH2O", curves.abdominal_Pa, [](const SeenBreath& b) { return b.abdominal_Pa; });
  if (p.compartment.elastance == 0.0) return;
  std::vector<double> across = curves.abdominal_Pa;
  for (std::size_t i = 0; i < across.size(); ++i) across[i] -= curves.pleural_Pa[i];
  add_swing("pleural_swing_cmH2O", curves.pleural_Pa, [](const SeenBreath& b) { return b.pleural_Pa; });
  add_swing("transdiaphragmatic_swing_cmH2O", across,
            [](const SeenBreath& b) { return Eigen::VectorXd(b.abdominal_Pa - b.pleural_Pa); });
}

}  // namespace

std::vector<FitResult> clinical_results(const FitPoints& points) {
  if (points.evidence().scale.empty()) return {};
  const TrunkAsCompartment& c = points.evidence().problem.compartment;
  std::vector<FitResult> all;
  const auto add = [&](const char* name, const char* unit, const Reading& reading) {
    all.push_back(graded(points, points.result(name, unit, points.read(reading), false)));
  };
  add("abdominal_elastance_cmH2O_per_L", "cmH2O/L",
      [&](const Candidate& x) { return per_unit * c.abdominal_elastance(x.parameters); });
  if (c.elastance > 0.0) {
    add("lung_elastance_cmH2O_per_L", "cmH2O/L",
        [](const Candidate& x) { return per_unit * x.parameters.lung_elastance; });
    add("respiratory_elastance_cmH2O_per_L", "cmH2O/L",
        [&](const Candidate& x) { return per_unit * c.respiratory_elastance(x.parameters); });
    add("resistance_cmH2O_s_per_L", "cmH2O s/L",
        [](const Candidate& x) { return per_unit * x.parameters.resistance; });
    all.push_back(peep_result(points));
  }
  add_swings(points, all);
  return all;
}

}  // namespace trunk
