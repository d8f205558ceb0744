#include "subject/subject_fit.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "records/provenance.hpp"
#include "scenarios/build_trunk.hpp"
#include "subject/fixed_parameters.hpp"
#include "trunks/read_trunk_pml.hpp"

namespace trunk {
namespace {

std::vector<std::string> timing_names() {
  std::vector<std::string> names = parameter_names({"timing"});
  names.emplace_back("fast_fall_level");
  return names;
}

void hold(const std::vector<FixedParameter>& fixed, ScenarioFile& file) {
  Candidate c{file.scenario.parameters, file.scenario.activation};
  for (const FixedParameter& held : fixed) {
    held.parameter->field(c) = held.value;
    if (held.source) file.inputs.push_back(*held.source);
  }
  file.scenario.parameters = c.parameters;
  file.scenario.activation = c.activation;
}

}  // namespace

SubjectFit::SubjectFit(ScenarioFile file, Measurement measurement, FitPlan plan)
    : file_(std::move(file)), measurement_(std::move(measurement)), plan_(std::move(plan)) {
  std::vector<std::string> beside;
  if (measurement_.breath) {
    const MeasuredBreath& breath = *measurement_.breath;
    measured_curve_ = measured_curve_of(breath, plan_.weighted);
    file_.scenario.time.duration_s = breath.duration_s;
    if (plan_.timing != Timing::scenario) {
      adopt_timing(breath, file_.scenario);
      timed_ = 3;
    }
    if (plan_.timing == Timing::joint) beside = timing_names();
  } else {
    measured_curve_ = {{}, {measurement_.tidal_volume_m3}, {}};
    plan_.timing = Timing::scenario;
  }
  std::vector<FixedParameter> fixed;
  for (const std::string& text : plan_.fixed) fixed.push_back(fixed_parameter(text));
  hold(fixed, file_);
  for (const FixedParameter& held : fixed) std::erase(beside, held.name());
  Mistakes mistakes;
  const auto names = names_to_fit(plan_.free, fixed, !measurement_.breath, mistakes);
  mistakes.settle();
  space_ = std::make_unique<SearchSpace>(
      names, Candidate{file_.scenario.parameters, file_.scenario.activation}, beside, plan_.priors);
  trunk_ = build_timed_trunk(file_, stiffer_in_searches);
}

std::string SubjectFit::problem_text() const {
  std::string text = version_text() + to_toml(file_.scenario);
  if (file_.scenario.mesh) text += trunk_pml(file_.scenario);
  for (const double t : measured_curve_.time_s) text += fmt::format("{},", t);
  return text;
}

Estimation SubjectFit::carry_out(Ledger& ledger) const {
  Estimation e =
      estimate(trunk_, file_.scenario.time, *space_, measured_curve_, plan_.estimation, ledger, timed_);
  if (!file_.scenario.step_choice || e.model.size() == 0) return e;
  const TimeGrid& grid = file_.scenario.time;
  const double error = time_step_error(trunk_.model, e.best.parameters, e.best.activation, grid);
  if (error > 2.0 * auto_time_step_tolerance)
    e.notes.push_back(fmt::format(
        "the time step of {:g} ms, chosen for the parameters at the start, is {} at the fitted ones: fit "
        "again from there (--set the fitted values) or with time.dt_ms=1",
        1e3 * grid.dt_s,
        finite(error) ? fmt::format("{:.2g} % of the tidal volume off", 100.0 * error) : "unstable"));
  return e;
}

ScenarioFile SubjectFit::fitted(const Estimation& e) const {
  ScenarioFile best = file_;
  best.scenario.parameters = e.best.parameters;
  best.scenario.activation = e.best.activation;
  return best;
}

std::string status_of(const Estimation& e) {
  if (!e.search.converged) return "not_converged";
  return e.uncertainty && e.uncertainty->identifiable ? "converged" : "not_identifiable";
}

}  // namespace trunk
