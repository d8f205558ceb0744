#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "commands/commands.hpp"
#include "commands/text/structure_text.hpp"
#include "files/replace_file.hpp"
#include "math/units.hpp"
#include "prediction/predict.hpp"
#include "records/provenance.hpp"
#include "records/run_record.hpp"
#include "records/stored_subject.hpp"
#include "results/write/write_run.hpp"
#include "scenarios/build_trunk.hpp"
#include "sheet/sheet.hpp"
#include "structure/ensemble.hpp"
#include "subject/structure_json.hpp"

namespace trunk {
namespace {

struct SimulateRequest {
  std::string scenario, output, parameters_from;
  std::vector<std::string> settings;
  std::optional<double> frame_every_ms;
  bool structural = false, not_structural = false;  // neither: if a fit gives intervals
};

/// What came of a simulation.
struct Simulated {
  BreathRun run;
  std::vector<Predicted> numbers;  // with intervals, where they are known
  std::size_t draws = 0;           // 0: no interval comes from a fit
  int failed_draws = 0;
  Structure structure{};
};

/// Returns the ends of all intervals that are known.
std::vector<NamedValue> all_intervals(const Simulated& s) {
  std::vector<NamedValue> ends;
  if (s.draws > 0) ends = intervals_of(s.numbers, s.failed_draws);
  if (!s.structure.empty())
    for (NamedValue& end : structural_intervals_of(s.numbers)) ends.push_back(std::move(end));
  return ends;
}

Json summary(const Trunk& trunk, const Scenario& scenario, const Simulated& s,
             const std::vector<NamedValue>& measures) {
  const BreathRun& run = s.run;
  Json json{{"schema", "trunk.simulate/1"}, {"status", status_word(run.ending.status)}};
  for (const Predicted& p : s.numbers) json[p.name] = json_number(p.value);
  for (const NamedValue& m : measures) json.emplace(m.name, json_number(m.value));
  // Without a lung there is no pleural pressure; a script finds the names all the same.
  for (const char* name : {"pleural_swing_cmH2O", "transdiaphragmatic_swing_cmH2O"})
    json.emplace(name, nullptr);
  for (const NamedValue& v : all_intervals(s)) json[v.name] = json_number(v.value);
  if (s.draws > 0) {
    json["draws"] = s.draws;
    json["failed_draws"] = s.failed_draws;
  }
  if (!s.structure.empty()) {
    for (const Predicted& p : s.numbers) json["structural_shares"][p.name] = shares_json(s.structure, p.name);
    add_choices(s.structure, json);
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

std::string table(const Simulated& s, const std::vector<NamedValue>& measures) {
  if (s.draws == 0 && s.structure.empty()) return aligned(measures);
  const auto range = [](double lower, double upper) {
    return shown(lower, "{:.4g}") + " to " + shown(upper, "{:.4g}");
  };
  std::string text = fmt::format("  {:<33}  {:>10}", "", "");
  if (s.draws > 0) text += fmt::format("  {:>22}", "interval of the fit");
  if (!s.structure.empty()) text += fmt::format("  {:>22}", "choices of the model");
  text += "\n";
  for (const Predicted& p : s.numbers) {
    text += fmt::format("  {:<33}  {:>10}", p.name, shown(p.value, "{:.4g}"));
    if (s.draws > 0) text += fmt::format("  {:>22}", range(p.lower95, p.upper95));
    if (!s.structure.empty())
      text += fmt::format("  {:>22}", range(p.structural_lower95, p.structural_upper95));
    text += fmt::format(" {}\n", p.unit == "1" ? "" : p.unit);
  }
  for (const NamedValue& m : measures)
    if (std::none_of(s.numbers.begin(), s.numbers.end(),
                     [&](const Predicted& p) { return p.name == m.name; }))
      text += fmt::format("  {:<33}  {:>10} {}\n", m.name, shown(m.value, "{:.4g}"), m.unit);
  return text + structure_table(s.structure, {"delta_v_ml", "excursion_right_mm", "excursion_left_mm",
                                              "delta_l_mm", "delta_h_mm"});
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

/// Returns the scenario in which the subject's tidal volume was measured: that of its fit, or else the same
/// one with nothing paralysed.
Scenario own_scenario(const StoredSubject& subject, const Scenario& scenario) {
  if (subject.own) return subject.own->scenario;
  Scenario healthy = scenario;
  healthy.tissue.paralysed = Side::none;
  return healthy;
}

Simulated simulated(const StoredSubject& subject, const ScenarioFile& file, const Trunk& trunk,
                    const SimulateRequest& request) {
  Simulated s{run_breath(trunk, file.scenario, frame_stride(file.scenario)), {}};
  if (const auto prediction = predicted(subject, file, trunk, request.settings)) {
    s.numbers = prediction->numbers;
    s.draws = prediction->delta_v_draws_m3.size();
    s.failed_draws = prediction->failed;
  } else {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    for (const NamedValue& m : measures_of(s.run))
      s.numbers.push_back({m.name, m.unit, m.value, unknown, unknown, unknown});
  }
  if (request.not_structural || !(request.structural || s.draws > 0)) return s;
  Execution execution;
  execution.cancelled = [] { return interrupted(); };
  s.structure = add_structural_intervals(own_scenario(subject, file.scenario), {file.scenario},
                                         declared_choices(), execution, {&s.numbers})
                    .front();
  return s;
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
  const Simulated s = simulated(subject, file, trunk, request);
  const BreathRun& run = s.run;
  RunRecord record = run_record(file, trunk, run, {}, provenance_of(file.inputs, common.argv));
  record.intervals = all_intervals(s);
  record.structure = s.structure;
  write_run(request.output, record);

  for (const FitRecord::Gate& gate : subject.gates)
    print_note(
        fmt::format("note: a gate stopped the fit {}, so this simulation tells nothing of the subject: {}",
                    request.parameters_from, gate.sentence));
  if (subject.own && s.draws == 0 && subject.gates.empty())
    print_note(fmt::format(
        "note: {} keeps no draws of its parameters, so no number here has an interval of the fit; "
        "fit the trace again to have them",
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
      run.ending.message, table(s, record.measures), bending, trunk.model.particles(), run.ending.steps,
      ms_per_s * file.scenario.time.dt_s, ms_per_s * run.wall_s, request.output);
  print_result(common, summary(trunk, file.scenario, s, record.measures), text);
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
  auto* structural = command->add_flag(
      "--structural", request->structural,
      "Gives every measure an interval over choices of the model that no measurement settles, and shows what "
      "each makes up. [with --from a fit]");
  command->add_flag("--no-structural", request->not_structural, "Leaves these intervals out.")
      ->excludes(structural);
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
