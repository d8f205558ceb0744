#include "subject/fit_job.hpp"

#include <fmt/format.h>

#include <charconv>
#include <chrono>
#include <cmath>

#include "channels/read_breaths.hpp"
#include "errors/input_error.hpp"
#include "files/replace_file.hpp"
#include "math/units.hpp"
#include "records/fit_record.hpp"
#include "records/provenance.hpp"
#include "records/stored_subject.hpp"
#include "results/write/write_fit.hpp"
#include "structure/ensemble.hpp"
#include "subject/channel_curves.hpp"
#include "subject/clinic_json.hpp"
#include "subject/record.hpp"

namespace trunk {
namespace {

MeasuredBreath chosen_breath(const Segmentation& s, const std::string& which,
                             std::vector<std::string>& notes) {
  if (which == "mean" || which == "each") return mean_breath(s);
  std::size_t number = 0;
  const char* end = which.data() + which.size();
  if (std::from_chars(which.data(), end, number).ptr != end || number == 0)
    throw InputError({"--breath " + which}, "this does not name a breath",
                     "mean, each or the number of a breath, from 1");
  MeasuredBreath breath = single_breath(s, number);
  if (const Breath& used = breath.used.front(); !used.kept)
    notes.push_back(fmt::format("breath {} would not be part of the mean breath: {}", number, used.reason));
  return breath;
}

/// Rounds what was fitted to six digits: more than any trace determines, and readable in a scenario file.
Scenario with_rounded(Scenario scenario, const SearchSpace& space) {
  Candidate c{scenario.parameters, scenario.activation};
  for (std::size_t i = 0; i < space.size(); ++i) {
    const FreeParameter& p = space.parameter(i);
    set_value(p, std::stod(fmt::format("{:.6g}", value_of(p, c))), c);
  }
  scenario.parameters = c.parameters;
  scenario.activation = c.activation;
  return scenario;
}

/// Gives the estimates of stiffness the intervals of the results, so that a number has one interval wherever
/// it stands.
void adopt_intervals(const FitResults& results, Estimation& e) {
  if (!e.uncertainty) return;
  const auto adopt = [&](Estimate& estimate, const char* name) {
    const FitResult* r = results.find(name);
    if (r == nullptr) return;
    if (!std::isfinite(r->value)) {  // withheld
      estimate.value = estimate.stderr_ = r->value;
      estimate.naive95 = {r->value, r->value};
    }
    estimate.lower95 = r->lower95;
    estimate.upper95 = r->upper95;
    estimate.identifiable = r->grade <= Grade::assumption;
  };
  for (Estimate& estimate : e.uncertainty->parameters)
    if (estimate.name == "k_elasticity" || estimate.name == "k_muscle")
      adopt(estimate, estimate.name.c_str());
  adopt(e.uncertainty->ratio, "k_muscle_over_k_elasticity");
}

/// What was measured stands in the place of what the model says.
void put_measured(FitResult measured, std::vector<FitResult>& results) {
  const auto same = std::find_if(results.begin(), results.end(),
                                 [&](const FitResult& r) { return r.name == measured.name; });
  if (same == results.end())
    results.push_back(std::move(measured));
  else
    *same = std::move(measured);
}

/// The fitted scenario in full: it needs no other file.
void save_scenario(const FitRequest& request, const Scenario& scenario) {
  const std::string text = fmt::format("# {} with the parameters of {}, written by trunk fit\n{}",
                                       request.scenario, request.output, to_toml(scenario));
  replace_file(request.save_scenario, std::as_bytes(std::span(text)));
}

}  // namespace

FitJob::FitJob(const FitRequest& request, Execution execution, FitListener listener)
    : request_(request), listener_(std::move(listener)) {
  ScenarioFile file = read_scenario(request_.scenario, request_.settings);
  FitPlan plan = plan_of(request_);
  plan.estimation.execution = std::move(execution);
  const Measurement measurement = measured();
  if (measurement.breath) file.inputs.emplace_back(request_.trace);
  fit_ = std::make_unique<SubjectFit>(std::move(file), measurement, plan);
  for (const std::string& note : fit_->screening().notes) notes_.push_back(note);
  if (each_ && !fit_->space().find("k_muscle"))
    throw InputError({"--breath each"}, "k_muscle is what it fits", "k_muscle among the free parameters");
  read_others();
}

Measurement FitJob::measured() {
  if (request_.trace.empty() == (request_.tidal_volume_ml == 0.0))
    throw InputError(Place{},
                     request_.trace.empty() ? "no measurement is named" : "two measurements are named",
                     "one of the two: --trace FILE or --tidal-volume-ml ML");
  if (request_.trace.empty()) {
    if (!(request_.tidal_volume_ml >= 10.0 && request_.tidal_volume_ml <= 10000.0))
      throw InputError({fmt::format("--tidal-volume-ml {:g}", request_.tidal_volume_ml)},
                       "no human breath has this volume", "10 to 10000 ml");
    if (request_.breath == "each")
      throw InputError({"--breath each"}, "one number has no breaths", "a trace: --trace FILE");
    return {std::nullopt, m3_per_ml * request_.tidal_volume_ml};
  }
  Segmentation s = read_breaths(request_.trace, request_.signal, request_.selection);
  notes_ = s.notes;
  Measurement measurement{chosen_breath(s, request_.breath, notes_), 0.0, trace_signs(s)};
  if (request_.breath == "each") each_ = std::move(s);
  return measurement;
}

void FitJob::read_others() {
  for (const std::string& path : request_.predict) {
    for (const OtherScenario& o : others_)
      if (short_name(o.file.path) == short_name(path))
        throw InputError({path}, "is predicted beside a scenario of the same name", "names that differ");
    others_.push_back(other_scenario(*fit_, path, request_.settings));
    if (!same_geometry(*fit_, others_.back()))
      notes_.push_back(path +
                       ": the trunk has another shape than the subject's; the prediction holds both changes");
  }
}

std::vector<std::filesystem::path> FitJob::inputs() const {
  std::vector<std::filesystem::path> all = fit_->file().inputs;
  for (const OtherScenario& o : others_) all.insert(all.end(), o.file.inputs.begin(), o.file.inputs.end());
  return all;
}

FitOutcome FitJob::carry_out() {
  const auto start = std::chrono::steady_clock::now();
  ledger_ = std::make_unique<Ledger>(ledger_file(), fit_->problem_text());
  FitOutcome outcome;
  outcome.input = std::filesystem::path(request_.trace).filename().string();
  outcome.notes = notes_;
  outcome.replayed = ledger_->found();
  const auto note = [&](const std::string& text) {
    outcome.notes.push_back(text);
    listener_.note(text);
  };
  if (outcome.replayed > 0)
    listener_.note(
        fmt::format("the fit goes on from {} simulations of an interrupted run", outcome.replayed));
  Estimation& e = outcome.estimation;
  try {
    e = fit_->carry_out(*ledger_);
  } catch (const InputError&) {
    if (outcome.replayed == 0) ledger_->discard();  // an option that makes no sense leaves nothing behind
    throw;
  }
  if (e.model.size() == 0) {
    ledger_->discard();
    throw std::runtime_error("no simulation completed (" + e.search.stop_reason + "): nothing written");
  }
  for (const std::string& text : e.notes) note(text);
  const bool gated = !fit_->screening().gates.empty();
  if (gated && (each_ || !others_.empty()))
    note(
        "a gate withholds what a muscle and a recoil explain, so no single breath is fitted and no other "
        "scenario "
        "is predicted");
  if (each_ && !gated)
    outcome.breaths = refit_each_breath(*fit_, e, *each_, [&](std::size_t done) {
      listener_.progress(fmt::format("fitting: {} breaths", done));
    });
  outcome.results = fit_->results(e);
  adopt_intervals(outcome.results, e);
  if (const auto& breath = fit_->measurement().breath)
    outcome.clinic = clinic_numbers(*breath, request_.clinic);
  for (FitResult& r : clinic_results(outcome.clinic)) put_measured(std::move(r), outcome.results.results);
  if (outcome.results.posterior && !gated)
    outcome.draws = fit_->draws(e, *outcome.results.posterior, static_cast<std::size_t>(request_.draws));
  if (!gated) outcome.predictions = predictions(outcome);
  outcome.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return outcome;
}

std::vector<Prediction> FitJob::predictions(const FitOutcome& outcome) const {
  std::vector<Candidate> candidates = {outcome.estimation.best};
  candidates.insert(candidates.end(), outcome.draws.begin(), outcome.draws.end());
  std::vector<std::pair<std::string, Drawn>> others;
  for (const OtherScenario& o : others_)
    others.emplace_back(o.file.path, Drawn{{o.trunk, o.file.scenario.time}, candidates});
  const Execution& execution = fit_->plan().estimation.execution;
  std::vector<Prediction> all =
      predict({{fit_->trunk(), fit_->file().scenario.time}, candidates}, others, execution);
  if (!request_.structural || all.empty()) return all;
  std::vector<Scenario> scenarios;
  std::vector<std::vector<Predicted>*> numbers;
  for (std::size_t k = 0; k < all.size(); ++k) {
    scenarios.push_back(others_[k].file.scenario);
    scenarios.back().parameters = candidates.front().parameters;
    scenarios.back().activation = candidates.front().activation;
    numbers.push_back(&all[k].numbers);
  }
  std::vector<Structure> structures = add_structural_intervals(
      fit_->fitted(outcome.estimation).scenario, scenarios, declared_choices(), execution, numbers);
  for (std::size_t k = 0; k < all.size(); ++k) all[k].structure = std::move(structures[k]);
  return all;
}

void FitJob::store(const FitOutcome& outcome, const std::string& argv) {
  const Estimation& e = outcome.estimation;
  const ScenarioFile best = fit_->fitted(e);
  const BreathRun run = run_breath(fit_->trunk(), best.scenario, frame_stride(best.scenario));
  const auto& breath = fit_->measurement().breath;
  Provenance provenance = provenance_of(inputs(), argv);
  provenance.seed = fit_->plan().estimation.search.seed;
  FitRecord record = fit_record(fit_->file(), fit_->trunk(), fit_->space(), fit_->measured_curve(),
                                breath ? breath->sigma_m3 : std::vector<double>(), e,
                                status_of(outcome.results.grade), run, provenance);
  if (breath) {
    record.statistics.push_back({"breaths_used", "1", static_cast<double>(breath->breaths_used)});
    record.statistics.push_back({"breaths_rejected", "1", static_cast<double>(breath->breaths_rejected)});
    if (breath->window) {
      record.statistics.push_back({"window_begin", "s", breath->window->begin_s});
      record.statistics.push_back({"window_end", "s", breath->window->end_s});
    }
  }
  record.channels = channel_curves(*fit_, e);
  record.input = outcome.input;
  record.notes = outcome.notes;
  add_results(outcome.results, record);
  add_starts(*fit_, record);
  add_breaths(outcome.breaths, record);
  if (breath) add_clinic(*breath, outcome.clinic, record);
  add_predictions(outcome.predictions, record);
  record.draws = draws_record(outcome.draws);
  write_fit(request_.output, record);
  if (!request_.save_scenario.empty()) save_scenario(request_, with_rounded(best.scenario, fit_->space()));
  ledger_->discard();
}

}  // namespace trunk
