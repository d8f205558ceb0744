#include <fmt/format.h>

#include <optional>

#include "anatomy/breath_run.hpp"
#include "anatomy/measures.hpp"
#include "channels/read_breaths.hpp"
#include "commands/commands.hpp"
#include "commands/options/fit_options.hpp"
#include "dynamics/stability.hpp"
#include "gates/gates.hpp"
#include "math/units.hpp"
#include "scenarios/build_trunk.hpp"
#include "scenarios/keys.hpp"
#include "sheet/sheet.hpp"
#include "subject/check_fit.hpp"
#include "subject/clinic_json.hpp"

namespace trunk {
namespace {

struct CheckRequest {
  FitRequest fit;  // a check looks at all of it but the search
  bool keys = false;
};

/// What a check gathers. All mistakes are printed, not only the first.
struct Findings {
  Mistakes mistakes;
  std::optional<Trunk> trunk;  // if it can be built
  std::vector<std::string> notes;
  Json json{{"schema", "trunk.check/1"}};
  std::string text;
};

void print_keys() {
  fmt::print("Keys of a scenario file, as table.key; --set takes the same names. Defaults in brackets.\n");
  for (const ScenarioKey& key : scenario_keys())
    fmt::print("  {:<38} {}: {} [{}]\n", key.path, key.meaning, expectation(key),
               toml_value(key, Scenario{}));
  fmt::print(
      "Beside these: schema = \"trunk.scenario/1\"; extends = \"other.toml\"; loads = \"file.lml\";\n"
      "gravity_m_s2 = [x, y, z]; abdominal_volume_fraction = [[time in s, fraction of rest], ...];\n"
      "[[force]] region, direction, events_N = [[time in s, N a particle], ...];\n"
      "[[displacement]] region, direction, axes = [1 where imposed, ...], events_mm = [[time in s, mm], "
      "...];\n"
      "[[acceleration]] region, direction, events_m_s2; [[pressure]] region, events_cmH2O, or along a "
      "direction;\n"
      "[[rigid]] region, motion = \"fixed\" | \"free\" | \"driven\", surface_for = region that slides along "
      "it;\n"
      "driven: axis, axis_point_mm, events_deg = [[time in s, degrees], ...]; or direction, events_mm.\n"
      "A region is a name, particles as in 0-3,7, or *. Tables add to those of the file that is extended.\n"
      "Directions are [right, forward, up].\n");
}

Json keys_json() {
  Json keys = Json::array();
  for (const ScenarioKey& key : scenario_keys())
    keys.push_back({{"key", key.path},
                    {"meaning", key.meaning},
                    {"expected", expectation(key)},
                    {"unit", unit_of_key(key.path)},
                    {"default", toml_value(key, Scenario{})}});
  return {{"schema", "trunk.check/1"}, {"keys", keys}};
}

std::optional<ScenarioFile> check_scenario(const CheckRequest& request, Findings& findings) {
  std::optional<ScenarioFile> file;
  findings.mistakes.gather([&] { file = read_scenario(request.fit.scenario, request.fit.settings); });
  if (!file) return file;
  findings.mistakes.gather([&] {
    const Trunk& trunk = findings.trunk.emplace(build_trunk(*file));
    const TimeGrid& time = file->scenario.time;
    const double bound_s = stable_time_step(trunk.model, file->scenario.parameters, time.damping);
    findings.json["scenario"] = request.fit.scenario;
    findings.json["particles"] = trunk.model.particles();
    findings.json["stable_dt_s"] = json_number(bound_s);
    if (!file->scenario.automatic_step) findings.json["steps"] = time.steps();
    const std::string steps = file->scenario.automatic_step
                                  ? std::string("a time step that trunk chooses")
                                  : fmt::format("{} steps of {:g} ms", time.steps(), 1e3 * time.dt_s);
    findings.text += fmt::format("{}: good. {} particles, {} (stable below {:.3g} ms)\n",
                                 request.fit.scenario, trunk.model.particles(), steps, 1e3 * bound_s);
    if (file->scenario.tissue.elasticity == ElasticLaw::ring) return;
    const double bending = bending_stiffness(file->scenario.parameters.elasticity);
    findings.json["bending_stiffness_N_m"] = bending;
    findings.text += fmt::format("k_elasticity {:.4g} N/m bends like a sheet of D = {:.3g} N m\n",
                                 file->scenario.parameters.elasticity, bending);
  });
  return file;
}

/// Returns what speaks against a fit. Only a size that does not fit the trunk costs a simulation.
Screening screened_beside(const Segmentation& segmentation, const ScenarioFile* file,
                          const Findings& findings) {
  if (!file || !findings.trunk) return screened(segmentation, std::nullopt);
  const Trunk& trunk = *findings.trunk;
  Screening screening = screened(segmentation, shape_of(trunk, trunk.model.rest).lung_volume);
  if (screening.gates.empty()) return screening;
  return screened(segmentation, end_expiratory_volume(trunk, file->scenario));
}

void check_trace(const CheckRequest& request, const ScenarioFile* file, Findings& findings) {
  findings.mistakes.gather([&] {
    const Segmentation segmentation =
        read_breaths(request.fit.trace, request.fit.signal, request.fit.selection);
    const MeasuredBreath breath = mean_breath(segmentation);
    findings.notes.insert(findings.notes.end(), segmentation.notes.begin(), segmentation.notes.end());
    const Screening screening = screened_beside(segmentation, file, findings);
    findings.json["gates"] = Json::array();
    for (const Gate& gate : screening.gates) {
      findings.json["gates"].push_back(gate.name);
      findings.notes.push_back(gate.sentence);
    }
    findings.notes.insert(findings.notes.end(), screening.notes.begin(), screening.notes.end());
    if (!segmentation.channels.empty() || segmentation.excursion_m)
      findings.json["channels"] = channels_json(segmentation);
    findings.json["breaths_used"] = breath.breaths_used;
    findings.json["tidal_volume_ml"] = ml_per_m3 * breath.tidal_volume_m3;
    findings.text += fmt::format(
        "{}: {}. {} breaths used, {} rejected, tidal volume {:.0f} ml, {:.2f} s a breath\n",
        request.fit.trace,
        screening.gates.empty() ? "good" : "read, but not to be fitted as it is (see the note)",
        breath.breaths_used, breath.breaths_rejected, ml_per_m3 * breath.tidal_volume_m3, breath.duration_s);
  });
}

/// Returns the mistake with the place that it names: a file and a line, or an option as it was typed.
Json problem_json(const Mistake& mistake) {
  const Place& at = mistake.at;
  const bool is_option = at.file.starts_with("--");
  Mistake without_place = mistake;
  without_place.at = {};
  return {{"file", at.file.empty() || is_option ? Json(nullptr) : Json(at.file)},
          {"line", at.line == 0 ? Json(nullptr) : Json(at.line)},
          {"option", is_option ? Json(at.file) : Json(nullptr)},
          {"text", text_of(without_place)}};
}

Exit print_findings(const Common& common, Findings& findings) {
  const bool good = findings.mistakes.empty();
  Json problems = Json::array();
  for (const Mistake& mistake : findings.mistakes.sorted()) {
    print_note("trunk: " + text_of(mistake));
    problems.push_back(problem_json(mistake));
  }
  for (const std::string& note : findings.notes)
    if (good) print_note("note: " + note);
  findings.json["problems"] = problems;
  findings.json["notes"] = findings.notes;
  if (!findings.text.empty()) findings.text.pop_back();  // its line end
  if (good || common.json) print_result(common, findings.json, findings.text);
  return good ? Exit::done : Exit::bad_input;
}

Exit check_command(const Common& common, CheckRequest request) {
  if (request.keys) {
    if (common.json)
      print_result(common, keys_json(), "");
    else
      print_keys();
    return Exit::done;
  }
  if (request.fit.scenario.empty() && request.fit.trace.empty())
    throw CLI::RequiredError("SCENARIO or --trace");
  Findings findings;
  findings.notes = settle_files(request.fit);
  const FitRequest& fit = request.fit;
  const std::optional<ScenarioFile> file = check_scenario(request, findings);
  if (!fit.trace.empty()) check_trace(request, file ? &*file : nullptr, findings);
  check_fit(fit, file, findings.mistakes);
  return print_findings(common, findings);
}

}  // namespace

void add_check(CLI::App& app, Common& common, Run& run) {
  auto* command = app.add_subcommand(
      "check", "Lists all mistakes in a scenario, a trace and the options of a fit, and simulates nothing.");
  const auto request = std::make_shared<CheckRequest>();
  add_scenario_option(*command, request->fit);
  add_subject_options(*command, request->fit);
  command->add_flag("--keys", request->keys, "Lists all keys of a scenario with units, limits and defaults.");
  add_json_flag(*command, common);
  command->footer(
      "Examples:\n"
      "  trunk check scenarios/healthy.toml --trace recording.csv\n"
      "  trunk check recording.csv --flow 2 --unit L/min\n"
      "  trunk check --keys");
  command->callback(
      [&common, &run, request] { run = [&common, request] { return check_command(common, *request); }; });
}

}  // namespace trunk
