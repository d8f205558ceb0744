#include "subject/subject_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "estimation/start.hpp"
#include "records/provenance.hpp"
#include "scenarios/build_trunk.hpp"
#include "trunks/read_trunk_pml.hpp"
#include "verdict/assess_fit.hpp"
#include "verdict/settling.hpp"
#include "verdict/straight_activation.hpp"

namespace trunk {
namespace {

/// Returns what speaks against a fit of this measurement.
Screening screened(const Measurement& measurement, double end_expiratory_m3) {
  if (measurement.signs) return trunk::screened(*measurement.signs, end_expiratory_m3);
  Screening screening;
  const double tidal_volume =
      measurement.breath ? measurement.breath->tidal_volume_m3 : measurement.tidal_volume_m3;
  if (const auto gate = subject_size(tidal_volume, end_expiratory_m3)) screening.gates.push_back(*gate);
  return screening;
}

bool is_machine(const Gate& gate) {
  return gate.name == "machine_driven";
}

}  // namespace

SubjectFit::SubjectFit(ScenarioFile file, Measurement measurement, FitPlan plan)
    : file_(std::move(file)), measurement_(std::move(measurement)), plan_(std::move(plan)) {
  FitDraft draft(plan_.free, plan_.fixed, !measurement_.breath);
  const Scenario given = file_.scenario;
  Scenario& scenario = file_.scenario;
  if (measurement_.breath) {
    if (!file_.settings.contains("time.start")) scenario.time.start = Start::periodic;
    measured_curve_ = measured_curve_of(*measurement_.breath, plan_.weighted);
    scenario.time.duration_s = measurement_.breath->duration_s;
    if (plan_.timing != Timing::scenario)
      scenario.activation = activation_from_landmarks(*measurement_.breath);
  } else {
    measured_curve_ = {{}, {measurement_.tidal_volume_m3}, {}, {}};
    plan_.timing = Timing::scenario;
  }
  if (measurement_.breath) give_lung();
  require_lung_for(draft, plan_.priors, scenario);
  draft.hold(file_);
  begin_ = scenario.parameters;
  if (plan_.timing == Timing::joint) draft.estimate_beside(plan_.straight);
  if (plan_.straight) plan_.priors = priors_of_straight_lines(plan_.priors, draft.beside);
  if (measurement_.breath) take_scale(draft);
  trunk_ = build_trunk(file_);
  Screening seen_in_trace = screened(measurement_, shape_of(trunk_, trunk_.model.rest).lung_volume);
  if (!seen_in_trace.gates.empty())
    seen_in_trace = screened(measurement_, end_expiratory_volume(trunk_, given));
  screening_.gates = seen_in_trace.gates;
  screening_.tidal_volume_error = seen_in_trace.tidal_volume_error;
  screening_.notes.insert(screening_.notes.end(), seen_in_trace.notes.begin(), seen_in_trace.notes.end());
  if (driven_by_airway()) std::erase_if(screening_.gates, is_machine);
  if (measurement_.breath) begin_with_compartment(draft);
  choose_step();
  if (measurement_.breath) calibrate_compartment(draft);
  space_ = std::make_unique<SearchSpace>(draft.names, Candidate{scenario.parameters, scenario.activation},
                                         draft.beside, plan_.priors);
}

bool SubjectFit::driven_by_airway() const {
  return file_.scenario.lung_acts && file_.scenario.pleura.airway_pressure.events().size() > 1;
}

FitProblem SubjectFit::problem() const {
  FitProblem problem{trunk_, file_.scenario.time, *space_, measured_curve_, compartment_, begin_, knowledge_};
  problem.correlation = correlation_;
  if (measurement_.breath) problem.breaths = breaths_of(*measurement_.breath, measured_curve_);
  return problem;
}

FitResults SubjectFit::results(const Estimation& e) const {
  const FitProblem asked = problem();
  return assess_fit({asked, e, measurement_.breath ? &*measurement_.breath : nullptr, screening_.gates,
                     screening_.tidal_volume_error, plan_.straight, scale_.empty() && !knowledge_.empty(),
                     straight_, searches_, scale_, driven_by_airway()});
}

std::vector<Candidate> SubjectFit::draws(const Estimation& e, const Posterior& posterior,
                                         std::size_t count) const {
  const unsigned seed = plan_.estimation.search.seed;
  if (scale_.empty()) return posterior_draws(posterior, *space_, count, seed);
  const FitProblem asked = problem();
  Settling settling(asked, e);
  return posterior_draws(posterior, *space_, count, seed, std::ref(settling));
}

std::string SubjectFit::problem_text() const {
  std::string text = version_text() + to_toml(file_.scenario);
  if (file_.scenario.mesh) text += trunk_pml(file_.scenario);
  for (const double t : measured_curve_.time_s) text += fmt::format("{},", t);
  for (const MeasuredObservable& o : measured_curve_.beside)
    text += fmt::format("beside {} {},", static_cast<int>(o.kind), o.value.size());
  return text;
}

Estimation SubjectFit::carry_out(Ledger& ledger) const {
  Estimation e = estimate(problem(), plan_.estimation, ledger);
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

std::string status_of(Grade grade) {
  if (grade == Grade::not_converged) return "not_converged";
  return grade == Grade::not_determined ? "not_identifiable" : "converged";
}

}  // namespace trunk
