#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "verdict/groups_of_results.hpp"
#include "verdict/reasons.hpp"

namespace trunk {
namespace {

FitResult recoil_result(const FitPoints& points) {
  const TrunkAsCompartment& compartment = points.evidence().problem.compartment;
  FitResult r = points.result(
      "recoil_time_s", "s",
      points.read([&](const Candidate& x) { return compartment.recoil_time_s(x.parameters); }), false);
  if (points.recoil()) {
    r.lower95 = points.recoil()->lower95_s;
    r.upper95 = points.recoil()->upper95_s;
  }
  const auto widening = [&](double limit) {
    return std::exp(std::hypot(std::log(limit / r.value), normal_quantile * TrunkAsCompartment::log_error));
  };
  r.lower95 = r.value / widening(r.lower95);
  r.upper95 = r.value * widening(r.upper95);
  r.assumption = course_assumption(points.evidence());
  return r;
}

FitResult stiffness_result(const FitPoints& points, bool muscle, const std::string& course) {
  const FitProblem& problem = points.evidence().problem;
  const Parameters<double>& best = points.best().parameters;
  const Reading reading = [&](const Candidate& x) {
    return muscle ? x.parameters.muscle : x.parameters.elasticity;
  };
  FitResult stiffness = muscle ? points.muscular("k_muscle", "N/m", reading)
                               : points.result("k_elasticity", "N/m", points.read(reading), false);
  if (!muscle &&
      points.recoil()) {  // the ends of the recoil time, not of the candidates: a bound may stop those
    stiffness.lower95 = std::max(problem.compartment.elasticity_of(points.recoil()->upper95_s, best), 0.0);
    stiffness.upper95 = problem.compartment.elasticity_of(points.recoil()->lower95_s, best);
  }
  const bool damped = static_cast<bool>(problem.space.find("damping"));
  stiffness.assumption = fmt::format("a damping of {:g} N s/m, which no volume can tell{}", best.damping,
                                     "; " + course_assumption(points.evidence()));
  points.grade(stiffness, damped ? "the damping is free, and volume gives no scale of forces" : course);
  return stiffness;
}

}  // namespace

std::vector<FitResult> parameter_results(const FitPoints& points) {
  const FitEvidence& in = points.evidence();
  const FitProblem& problem = in.problem;
  const std::string course = course_reason(in, points.recoil());
  std::vector<FitResult> all;
  all.push_back(points.muscular("r_ei", "1", [&](const Candidate& x) {
    return muscle_against_recoil(problem.compartment, x, problem.grid, problem.measured);
  }));
  if (in.scale.empty()) grade_inspiration(in, all.back());
  points.grade(all.back(), "");
  all.push_back(recoil_result(points));
  points.grade(all.back(), course);
  const bool elasticity = problem.space.find("k_elasticity").has_value(),
             muscle = problem.space.find("k_muscle").has_value();
  if (!elasticity && !muscle) return all;
  all.push_back(points.muscular("k_muscle_over_k_elasticity", "1", [](const Candidate& x) {
    return x.parameters.muscle / x.parameters.elasticity;
  }));
  all.back().assumption = course_assumption(in);
  points.grade(all.back(), course);
  if (elasticity) all.push_back(stiffness_result(points, false, course));
  if (muscle) all.push_back(stiffness_result(points, true, course));
  return all;
}

}  // namespace trunk
