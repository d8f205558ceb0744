#include <fmt/format.h>

#include <cmath>

#include "commands/commands.hpp"
#include "files/replace_file.hpp"
#include "records/provenance.hpp"
#include "records/run_record.hpp"
#include "results/read/stored_run.hpp"
#include "results/write/write_run.hpp"
#include "scenarios/build_trunk.hpp"

namespace trunk {
namespace {

struct SimulateRequest {
  std::string scenario, output, parameters_from;
  std::vector<std::string> settings;
  std::optional<double> frame_every_ms;
};

Json summary(const Trunk& trunk, const Scenario& scenario, const BreathRun& run) {
  Json json{{"schema", "trunk.simulate/1"}, {"status", status_word(run.ending.status)}};
  for (const NamedValue& v : measures_of(run)) json[v.name] = json_number(v.value);
  json["particles"] = trunk.model.particles();
  json["triangles"] = trunk.mesh.distinct_triangles();
  json["steps"] = run.ending.steps;
  json["dt_s"] = scenario.time.dt_s;
  if (const auto& choice = scenario.step_choice) {
    json["dt_chosen"] = "auto";
    json["dt_stable_s"] = json_number(choice->stable_s);
    json["dt_estimated_error_percent"] = json_number(100.0 * choice->estimated_error);
  }
  json["wall_s"] = run.wall_s;
  json["message"] = run.ending.message;
  return json;
}

/// Loads act from the first moment on the rest shape, so that a part of the measured change is theirs.
void note_loads(const Scenario& s, const BreathRun& run) {
  constexpr double ml = 1e-6;
  const bool loaded = dot(s.gravity, s.gravity) > 0.0 || !s.loads.empty();
  if (!loaded || !run.ending.completed()) return;
  const double at_end = run.delta_v.back() / ml;
  if (std::abs(at_end) > 1.0)
    print_note(
        fmt::format("note: gravity or loads: the lung ends {:+.0f} ml from its volume at rest, to which the "
                    "measures refer",
                    at_end));
}

Exit simulate_command(const Common& common, const SimulateRequest& request) {
  ScenarioFile file = read_scenario(request.scenario);
  if (!request.parameters_from.empty()) {
    adopt_parameters(read_parameters(request.parameters_from), file.scenario);
    file.inputs.push_back(request.parameters_from);
  }
  apply_settings(request.settings, file);
  if (request.frame_every_ms) file.scenario.frame_every_s = 1e-3 * *request.frame_every_ms;
  require_apart(file.inputs, {request.output});
  const Trunk trunk = build_timed_trunk(file);
  require_writable_output(request.output, common.force);
  const BreathRun run = run_breath(trunk, file.scenario, frame_stride(file.scenario));
  write_run(request.output, run_record(file, trunk, run, {}, provenance_of(file.inputs, common.argv)));

  note_loads(file.scenario, run);
  if (run.flipped_triangles > 0)
    print_note(fmt::format(
        "note: {} triangles of the lung turned over: the breath is deeper than this model can follow",
        run.flipped_triangles));
  const std::string text =
      fmt::format("{}: {}\n{}  {} particles, {} steps of {:g} ms in {:.1f} ms; written to {}",
                  file.scenario.title, run.ending.message, aligned(measures_of(run)), trunk.model.particles(),
                  run.ending.steps, 1e3 * file.scenario.time.dt_s, 1e3 * run.wall_s, request.output);
  print_result(common, summary(trunk, file.scenario, run), text);
  return run.ending.completed() ? Exit::done : Exit::not_converged;
}

}  // namespace

void add_simulate(CLI::App& app, Common& common, Run& run) {
  auto* command = app.add_subcommand("simulate", "Simulate one scenario and keep the whole trajectory");
  const auto request = std::make_shared<SimulateRequest>();
  command->add_option("SCENARIO", request->scenario, "scenario file (TOML)")->required();
  command->add_option("-o,--output", request->output, "result file (HDF5)")->required();
  command->add_option("--set", request->settings, "key=value, over the scenario; may be repeated")
      ->take_all();
  command->add_option("--from", request->parameters_from,
                      "take k_elasticity, k_muscle, damping and the activation's course of this fit or run "
                      "(HDF5), not its geometry; --set goes over it");
  command
      ->add_option(
          "--every", request->frame_every_ms,
          "ms between the frames of the stored trajectory [time.frame_every_ms of the scenario, 10]; "
          "0: a summary, with no trajectory and curves every 10 ms")
      ->check(within(0.0, 1e6));
  command->add_flag("--json", common.json, "print one JSON object");
  command->add_flag("--force", common.force, "replace the result file if it exists");
  command->callback(
      [&common, &run, request] { run = [&common, request] { return simulate_command(common, *request); }; });
}

}  // namespace trunk
