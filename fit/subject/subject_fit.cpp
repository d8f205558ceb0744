#include "subject/subject_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "errors/input_error.hpp"
#include "records/provenance.hpp"
#include "results/read/stored_run.hpp"
#include "scenarios/build_trunk.hpp"
#include "trunks/read_trunk_pml.hpp"

namespace trunk {
namespace {

std::vector<std::string> timing_names() {
  std::vector<std::string> names = parameter_names({"timing"});
  names.emplace_back("fast_fall_level");
  return names;
}

double number_in(const std::string& text, const std::string& option, const std::string& expected) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) throw InputError(option + ": " + expected);
  return value;
}

/// --fix name=value or name=@file.h5. Returns the name.
std::string apply_fixed(const std::string& text, ScenarioFile& file) {
  const std::string expected = "expected name=value or name=@file.h5, as in --fix k_elasticity=4000";
  const auto equals = text.find('=');
  if (equals == std::string::npos) throw InputError("--fix " + text + ": " + expected);
  const std::string name = text.substr(0, equals), value = text.substr(equals + 1);
  const FreeParameter& p = free_parameter(name);
  Candidate c{file.scenario.parameters, file.scenario.activation};
  if (value.starts_with('@')) {
    const std::filesystem::path source = value.substr(1);
    for (const NamedValue& v : read_parameters(source))
      if (v.name == name) p.field(c) = v.value;
    file.inputs.push_back(source);
  } else {
    p.field(c) = number_in(value, "--fix " + text, expected);
  }
  if (!(p.field(c) >= p.lower && p.field(c) <= p.upper))
    throw InputError(fmt::format("--fix {}: expected {:g} to {:g} {}", text, p.lower, p.upper, p.unit));
  file.scenario.parameters = c.parameters;
  file.scenario.activation = c.activation;
  return name;
}

/// What to fit: what the plan says, or the two of the paper (one where there is but one number), less what is
/// fixed.
std::vector<std::string> names_to_fit(const FitPlan& plan, const Measurement& measurement,
                                      const std::vector<std::string>& fixed) {
  std::vector<std::string> names = parameter_names(plan.free);
  if (names.empty())
    names = measurement.breath ? std::vector<std::string>{"k_elasticity", "k_muscle"}
                               : std::vector<std::string>{"k_muscle"};
  for (const std::string& name : fixed) {
    if (!plan.free.empty() && std::count(names.begin(), names.end(), name) > 0)
      throw InputError("parameter '" + name + "' is both free and fixed, expected one of the two");
    std::erase(names, name);
  }
  return names;
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
  std::vector<std::string> fixed;
  for (const std::string& text : plan_.fixed) fixed.push_back(apply_fixed(text, file_));
  for (const std::string& name : fixed) std::erase(beside, name);
  space_ = std::make_unique<SearchSpace>(names_to_fit(plan_, measurement_, fixed),
                                         Candidate{file_.scenario.parameters, file_.scenario.activation},
                                         beside, plan_.priors);
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
