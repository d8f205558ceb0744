#include <fmt/format.h>

#include <charconv>
#include <chrono>
#include <cmath>

#include "breaths/mean_breath.hpp"
#include "commands/commands.hpp"
#include "commands/fit_options.hpp"
#include "commands/fit_text.hpp"
#include "errors/input_error.hpp"
#include "recording/fit_record.hpp"
#include "recording/provenance.hpp"
#include "recording/run_record.hpp"
#include "results/fit_file.hpp"
#include "results/target_file.hpp"

namespace trunk {
namespace {

/// The breath to fit. `notes` are for the user, once all input is known to be good.
MeasuredBreath measured_breath(const FitRequest& request, std::vector<std::string>& notes) {
  const Segmentation s = segment_breaths(read_signal(request.trace, request.signal));
  notes = s.notes;
  if (request.breath == "mean") return mean_breath(s);
  std::size_t number = 0;
  const char* end = request.breath.data() + request.breath.size();
  if (std::from_chars(request.breath.data(), end, number).ptr != end || number == 0)
    throw InputError("--breath " + request.breath + ": expected mean or the number of a breath, from 1");
  const MeasuredBreath breath = single_breath(s, number);
  if (!s.breaths[number - 1].kept)
    notes.push_back(
        fmt::format("breath {} would be left out of the mean: {}", number, s.breaths[number - 1].reason));
  return breath;
}

Measurement measurement_of(const FitRequest& request, std::vector<std::string>& notes) {
  if (request.trace.empty() == (request.tidal_volume_ml == 0.0))
    throw InputError("expected a measurement: --trace FILE or --tidal-volume-ml ML, one of the two");
  if (request.trace.empty() && !(request.tidal_volume_ml >= 10.0 && request.tidal_volume_ml <= 10000.0))
    throw InputError(fmt::format("--tidal-volume-ml {:g}: expected 10 to 10000 ml", request.tidal_volume_ml));
  if (request.trace.empty()) return {std::nullopt, 1e-6 * request.tidal_volume_ml};
  return {measured_breath(request, notes), 0.0};
}

/// Six digits are more than any trace determines, and stay readable in a scenario file.
Scenario with_rounded(Scenario scenario, const SearchSpace& space) {
  Candidate c{scenario.parameters, scenario.activation};
  for (std::size_t i = 0; i < space.size(); ++i) {
    double& value = space.parameter(i).field(c);
    value = std::stod(fmt::format("{:.6g}", value));
  }
  scenario.parameters = c.parameters;
  scenario.activation = c.activation;
  return scenario;
}

/// The fitted scenario in full: it needs no other file.
void save_scenario(const FitRequest& request, const Scenario& scenario) {
  const std::string text = fmt::format("# {} with the parameters of {}, written by trunk fit\n{}",
                                       request.scenario, request.output, to_toml(scenario));
  replace_file(request.save_scenario, std::as_bytes(std::span(text)));
}

void require_results_free(const Common& common, const FitRequest& request, const ScenarioFile& file) {
  std::vector<std::filesystem::path> outputs = {request.output};
  if (!request.save_scenario.empty()) outputs.emplace_back(request.save_scenario);
  require_apart(file.inputs, outputs);
  for (const auto& output : outputs) require_writable_target(output, common.force);
}

Execution watched() {
  const auto report = [](std::size_t evaluations) {
    print_progress(fmt::format("fitting: {} evaluations", evaluations));
  };
  return {0, [] { return interrupted(); }, report};
}

void write_result(const Common& common, const FitRequest& request, const SubjectFit& fit,
                  const Estimation& e) {
  const ScenarioFile best = fit.fitted(e);
  const int stride =
      std::max(1, static_cast<int>(std::lround(best.scenario.frame_every_s / best.scenario.time.dt_s)));
  const BreathRun run = run_breath(fit.trunk(), best.scenario, stride);
  const auto& breath = fit.measurement().breath;
  write_fit(request.output, fit_record(fit.file(), fit.trunk(), fit.space(), fit.target(),
                                       breath ? breath->sigma_m3 : std::vector<double>(), e, status_of(e),
                                       run, provenance_of(fit.file().inputs, common.argv)));
  if (!request.save_scenario.empty()) save_scenario(request, with_rounded(best.scenario, fit.space()));
}

Exit fit_command(const Common& common, const FitRequest& request) {
  std::vector<std::string> notes;
  ScenarioFile file = read_scenario(request.scenario, request.settings);
  FitPlan plan = plan_of(request);
  const Measurement measurement = measurement_of(request, notes);
  if (measurement.breath) file.inputs.push_back(request.trace);
  const unsigned threads = plan.estimation.execution.threads;
  plan.estimation.execution = watched();
  plan.estimation.execution.threads = threads;
  const SubjectFit fit(std::move(file), measurement, plan);
  require_results_free(common, request, fit.file());
  for (const std::string& note : notes) print_note("note: " + note);

  catch_interrupts();
  const auto start = std::chrono::steady_clock::now();
  const std::string ledger_file = request.output + ".ledger";
  Ledger ledger(ledger_file, fit.problem_text());
  const std::size_t found = ledger.found();
  if (found > 0) print_note(fmt::format("note: goes on from {} simulations of an interrupted run", found));
  Estimation e;
  try {
    e = fit.carry_out(ledger);
  } catch (const Cancelled&) {
    print_note(
        fmt::format("interrupted: nothing written but {}, from which the same command goes on", ledger_file));
    return Exit::interrupted;
  }
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  if (e.model.size() == 0) {
    ledger.discard();
    throw std::runtime_error("no simulation completed (" + e.search.stop_reason + "): nothing written");
  }
  write_result(common, request, fit, e);
  ledger.discard();
  for (const std::string& note : e.notes) print_note("note: " + note);
  print_result(common, fit_json(fit, e, found, wall.count()),
               fit_table(fit, e, found) + "\nWritten to " + request.output);
  if (!e.search.converged) return Exit::not_converged;
  return status_of(e) == "converged" ? Exit::done : Exit::not_identifiable;
}

}  // namespace

void add_fit(CLI::App& app, Common& common, Run& run) {
  auto* command = app.add_subcommand("fit", "Fit k_elasticity and k_muscle to a lung volume trace");
  const auto r = std::make_shared<FitRequest>();
  command->add_option("SCENARIO", r->scenario, "scenario file (TOML)")->required();
  command->add_option("--trace", r->trace, "lung volume or flow trace (CSV)");
  command->add_option("--tidal-volume-ml", r->tidal_volume_ml,
                      "fit k_muscle to this one number instead of a trace");
  command->add_option("-o,--output", r->output, "result file (HDF5)")->required();
  command->add_option("--breath", r->breath, "mean, or the number of one breath [mean]");
  command->add_option("--save-scenario", r->save_scenario,
                      "write the scenario with the fitted values to this file");
  add_fit_options(*command, *r);
  add_signal_options(*command, r->signal);
  command->add_flag("--json", common.json, "print one JSON object");
  command->add_flag("--force", common.force, "replace result files that exist");
  command->callback([&common, &run, r] { run = [&common, r] { return fit_command(common, *r); }; });
}

}  // namespace trunk
