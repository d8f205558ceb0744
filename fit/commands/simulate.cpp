#include <fmt/format.h>

#include <cmath>

#include "commands/commands.hpp"
#include "files/replace_file.hpp"
#include "math/units.hpp"
#include "prediction/predict.hpp"
#include "records/provenance.hpp"
#include "records/run_record.hpp"
#include "records/stored_subject.hpp"
#include "results/write/write_run.hpp"
#include "scenarios/build_trunk.hpp"
#include "sheet/sheet.hpp"

namespace trunk {
namespace {

struct SimulateRequest {
  std::string scenario, output, parameters_from;
  std::vector<std::string> settings;
  std::optional<double> frame_every_ms;
};

Json summary(const Trunk& trunk, const Scenario& scenario, const BreathRun& run,
             const std::optional<Prediction>& prediction) {
  Json json{{"schema", "trunk.simulate/1"}, {"status", status_word(run.ending.status)}};
  for (const NamedValue& v : measures_of(run)) json[v.name] = json_number(v.value);
  if (prediction) {
    for (const Predicted& p : prediction->numbers) json[p.name] = json_number(p.value);
    for (const NamedValue& v : intervals_of(prediction->numbers, prediction->failed))
      json[v.name] = json_number(v.value);
    json["draws"] = prediction->delta_v_draws_m3.size();
    json["failed_draws"] = prediction->failed;
  }
  json["particles"] = trunk.model.particles();
  json["triangles"] = trunk.mesh.distinct_triangles();
  json["steps"] = run.ending.steps;
  json["dt_s"] = scenario.time.dt_s;
  if (const auto& choice = scenario.step_choice) {
    json["dt_chosen"] = "auto";
    json["dt_stable_s"] = json_number(choice->stable_s);
    json["dt_estimated_error_percent"] = json_number(100.0 * choice->estimated_error);
  }
  if (scenario.tissue.elasticity == ElasticLaw::sheet)
    json["bending_stiffness_N_m"] = bending_stiffness(scenario.parameters.elasticity);
  json["wall_s"] = run.wall_s;
  json["message"] = run.ending.message;
  return json;
}

/// Tells the user that loads act on the rest shape from the first moment on, so that they cause a part of the
/// measured change.
void note_loads(const Scenario& s, const BreathRun& run) {
  const bool loaded = dot(s.gravity, s.gravity) > 0.0 || !s.loads.empty();
  if (!loaded || !run.ending.completed()) return;
  const double at_end = ml_per_m3 * run.delta_v.back();
  if (s.time.start == Start::periodic)
    print_note(
        "note: gravity and loads move the trunk from its rest shape; this is in the volume above relaxation");
  else if (std::abs(at_end) > 1.0)
    print_note(fmt::format(
        "note: because of gravity or loads, the lung ends {:+.0f} ml from its volume at rest; the "
        "measures refer to the volume at rest",
        at_end));
}

std::string table(const BreathRun& run, const std::optional<Prediction>& prediction) {
  if (!prediction) return aligned(measures_of(run));
  std::string text;
  for (const Predicted& p : prediction->numbers)
    text += fmt::format("  {:<33}  {:>10}  {:>22} {}\n", p.name, shown(p.value, "{:.4g}"),
                        shown(p.lower95, "{:.4g}") + " to " + shown(p.upper95, "{:.4g}"),
                        p.unit == "1" ? "" : p.unit);
  return text;
}

/// Returns what the draws of the fit do in the scenario; none if there are no draws. Throws Cancelled.
std::optional<Prediction> predicted(const StoredSubject& subject, const ScenarioFile& file,
                                    const Trunk& trunk, const std::vector<std::string>& settings) {
  if (subject.draws.empty()) return std::nullopt;
  const ScenarioFile& own = *subject.own;
  const Trunk own_trunk = build_trunk(own);
  Drawn at_home{{own_trunk, own.scenario.time}, {{own.scenario.parameters, own.scenario.activation}}},
      there{{trunk, file.scenario.time}, {{file.scenario.parameters, file.scenario.activation}}};
  std::vector<Setting> all;
  for (const std::string& text : settings) all.push_back(setting_of(text));
  for (const Candidate& draw : subject.draws) at_home.candidates.push_back(draw);
  for (const Candidate& draw : draws_in(file, subject.draws, all)) there.candidates.push_back(draw);
  Execution execution;
  execution.cancelled = [] { return interrupted(); };
  return predict(at_home, {{file.path, there}}, execution).front();
}

Exit simulate_command(const Common& common, const SimulateRequest& request) {
  ScenarioFile file = read_scenario(request.scenario);
  StoredSubject subject;
  if (!request.parameters_from.empty()) {
    subject = read_stored_subject(request.parameters_from);
    breathe_as(subject, file.scenario);
    file.inputs.push_back(request.parameters_from);
  }
  apply_settings(request.settings, file);
  if (request.frame_every_ms) file.scenario.frame_every_s = s_per_ms * *request.frame_every_ms;
  require_apart(file.inputs, {request.output});
  const Trunk trunk = build_timed_trunk(file, subject.draws.empty() ? 1.0 : stiffer_in_searches);
  require_writable_output(request.output, common.force);
  const BreathRun run = run_breath(trunk, file.scenario, frame_stride(file.scenario));
  const std::optional<Prediction> prediction = predicted(subject, file, trunk, request.settings);
  RunRecord record = run_record(file, trunk, run, {}, provenance_of(file.inputs, common.argv));
  if (prediction) record.intervals = intervals_of(prediction->numbers, prediction->failed);
  write_run(request.output, record);

  if (subject.own && !prediction)
    print_note(
        fmt::format("note: {} keeps no draws of its parameters, so no number here has an interval; fit "
                    "the trace again to have them",
                    request.parameters_from));
  note_loads(file.scenario, run);
  if (run.flipped_triangles > 0)
    print_note(fmt::format(
        "note: {} triangles of the lung turned over: the breath is deeper than this model can follow",
        run.flipped_triangles));
  const Parameters<double>& parameters = file.scenario.parameters;
  const std::string bending =
      file.scenario.tissue.elasticity == ElasticLaw::ring
          ? ""
          : fmt::format("  k_elasticity {:.4g} N/m bends like a sheet of D = {:.3g} N m\n",
                        parameters.elasticity, bending_stiffness(parameters.elasticity));
  const std::string text = fmt::format(
      "{}: {}\n{}{}  {} particles, {} steps of {:g} ms in {:.1f} ms; written to {}", file.scenario.title,
      run.ending.message, table(run, prediction), bending, trunk.model.particles(), run.ending.steps,
      ms_per_s * file.scenario.time.dt_s, ms_per_s * run.wall_s, request.output);
  print_result(common, summary(trunk, file.scenario, run, prediction), text);
  return run.ending.completed() ? Exit::done : Exit::not_converged;
}

}  // namespace

void add_simulate(CLI::App& app, Common& common, Run& run) {
  auto* command = app.add_subcommand(
      "simulate",
      "Simulates one scenario and writes the result, with the whole motion of the trunk, to a file.");
  const auto request = std::make_shared<SimulateRequest>();
  command->add_option("SCENARIO", request->scenario, "The scenario file (TOML).")->required();
  command->add_option("-o,--output", request->output, "Writes the result to this file (HDF5).")
      ->type_name("FILE")
      ->required();
  command
      ->add_option("--set", request->settings,
                   "Sets a key of the scenario. You can repeat it. `trunk check --keys` lists the keys.")
      ->type_name("KEY=VALUE")
      ->take_all();
  command
      ->add_option(
          "--from", request->parameters_from,
          "Takes k_elasticity, k_muscle, damping and the course of the activation from this fit or "
          "run (HDF5). A fit also gives the period, and whether breathing repeats, and every measure "
          "has an interval. The geometry stays the scenario's, and --set overrides both.")
      ->type_name("FILE");
  command
      ->add_option(
          "--every", request->frame_every_ms,
          "Stores the motion at this interval, in ms. 0 stores no motion, and curves every 10 ms. [the "
          "scenario's time.frame_every_ms, 10]")
      ->type_name("MS")
      ->check(within(0.0, 1e6));
  add_json_flag(*command, common);
  add_force_flag(*command, common, "Replaces the result file if it exists.");
  command->footer(
      "Examples:\n"
      "  trunk simulate scenarios/healthy.toml -o healthy.h5\n"
      "  trunk simulate scenarios/hemiparalysis_right.toml --from fit.h5 -o right.h5");
  command->callback(
      [&common, &run, request] { run = [&common, request] { return simulate_command(common, *request); }; });
}

}  // namespace trunk
