#include "verdict/assess_fit.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "verdict/groups_of_results.hpp"
#include "verdict/reasons.hpp"
#include "verdict/sentences.hpp"

namespace trunk {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Returns results without an interval: one number tells one parameter, and nothing of how exactly.
std::vector<FitResult> one_number_results(const Uncertainty& uncertainty) {
  std::vector<FitResult> all;
  for (const Estimate& e : uncertainty.parameters) {
    FitResult r{e.name, e.unit, e.value, unknown, unknown, Grade::assumption};
    r.assumption = "all else is as in the scenario; one tidal volume shows no spread";
    r.meaning = meaning_of(e.name);
    if (e.at_bound) set_reason(r, e.name + " stopped at its bound");
    all.push_back(std::move(r));
  }
  return all;
}

std::vector<std::string> headline_of(const FitResults& results, bool forces) {
  static constexpr std::array of_volume = {
      "r_ei",     "recoil_time_s",      "k_muscle_over_k_elasticity", "k_elasticity",
      "k_muscle", "excursion_right_mm", "excursion_left_mm",          "delta_l_mm"};
  static constexpr std::array of_pressures = {"k_muscle",
                                              "abdominal_elastance_cmH2O_per_L",
                                              "lung_elastance_cmH2O_per_L",
                                              "respiratory_elastance_cmH2O_per_L",
                                              "resistance_cmH2O_s_per_L",
                                              "recoil_time_s",
                                              "transdiaphragmatic_swing_cmH2O",
                                              "excursion_right_mm"};
  std::vector<std::string> headline;
  for (const char* name : forces ? of_pressures : of_volume)
    if (results.find(name)) headline.emplace_back(name);
  return headline;
}

/// A gate withholds all that a muscle and a recoil explain. => results
void withhold(FitResults& results) {
  if (results.gates.empty()) return;
  const auto muscular = [](const std::string& name) { return !name.ends_with("_mm"); };
  for (std::vector<FitResult>* list :
       {&results.results, results.straight ? &results.straight->results : nullptr})
    if (list != nullptr)
      for (FitResult& r : *list) {
        if (muscular(r.name)) r.value = r.lower95 = r.upper95 = unknown;
        set_reason(r, results.gates.front().sentence);
      }
}

/// No single result is better than the search. => results
void distrust(FitResults& results) {
  for (FitResult& r : results.results) {
    set_reason(r, results.gates.empty() ? "the search did not converge" : r.reason);
    if (results.gates.empty()) r.grade = Grade::not_converged;
  }
}

/// Whatever the search found, a recording behind a gate determines nothing.
Grade worst_of(const FitResults& results, bool converged) {
  if (!results.gates.empty()) return Grade::not_determined;
  if (!converged) return Grade::not_converged;
  Grade grade = Grade::determined;
  for (const std::string& name : results.headline) grade = std::max(grade, results.find(name)->grade);
  return results.headline.empty() ? Grade::not_determined : grade;
}

}  // namespace

FitResults assess_fit(const FitEvidence& in) {
  const Estimation& e = in.estimation;
  FitResults results;
  results.gates = in.gates;
  results.straight = in.straight_lines;
  if (e.search.converged && e.local) {
    const FitPoints points(in);
    results.posterior = points.posterior();
    for (const auto group : {&parameter_results, &clinical_results, &measure_results})
      for (FitResult& r : group(points)) results.results.push_back(std::move(r));
  } else if (e.search.converged && in.problem.measured.is_tidal_volume() && e.uncertainty) {
    results.results = one_number_results(*e.uncertainty);
  }
  results.headline = headline_of(results, pressure_measured(in));
  withhold(results);
  const bool converged = e.search.converged && !(e.cross_check && !e.cross_check->agree);
  if (!converged) distrust(results);
  results.grade = worst_of(results, converged);
  results.verdict = verdict_sentence(results, in);
  return results;
}

}  // namespace trunk
