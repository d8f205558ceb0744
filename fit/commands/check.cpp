#include <fmt/format.h>

#include "breaths/mean_breath.hpp"
#include "commands/commands.hpp"
#include "commands/trace_options.hpp"
#include "dynamics/stability.hpp"
#include "io/scenario_file.hpp"
#include "io/scenario_keys.hpp"

namespace trunk {
namespace {

struct CheckRequest {
  std::string scenario, trace;
  std::vector<std::string> settings;
  SignalOptions signal;
  bool keys = false;
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

Exit check_command(const Common& common, const CheckRequest& request) {
  if (request.keys) {
    if (common.json)
      print_result(common, keys_json(), "");
    else
      print_keys();
    return Exit::done;
  }
  if (request.scenario.empty()) throw CLI::RequiredError("SCENARIO");
  const ScenarioFile file = read_scenario(request.scenario, request.settings);
  const Trunk trunk = build_trunk(file);
  const double bound_s = stable_time_step(trunk.model, file.scenario.parameters);
  Json json{{"schema", "trunk.check/1"},
            {"scenario", request.scenario},
            {"particles", trunk.model.particles()},
            {"steps", file.scenario.time.steps()},
            {"stable_dt_s", json_number(bound_s)}};
  std::string text = fmt::format("{}: good. {} particles, {} steps of {:g} ms (stable below {:.3g} ms)",
                                 request.scenario, trunk.model.particles(), file.scenario.time.steps(),
                                 1e3 * file.scenario.time.dt_s, 1e3 * bound_s);
  if (!request.trace.empty()) {
    const MeasuredBreath breath = mean_breath(segment_breaths(read_signal(request.trace, request.signal)));
    json["breaths_used"] = breath.breaths_used;
    json["tidal_volume_ml"] = 1e6 * breath.tidal_volume_m3;
    text += fmt::format("\n{}: good. {} breaths used, {} rejected, tidal volume {:.0f} ml, {:.2f} s a breath",
                        request.trace, breath.breaths_used, breath.breaths_rejected,
                        1e6 * breath.tidal_volume_m3, breath.duration_s);
  }
  print_result(common, json, text);
  return Exit::done;
}

}  // namespace

void add_check(CLI::App& app, Common& common, Run& run) {
  auto* command = app.add_subcommand("check", "Validate a scenario and a trace; simulate nothing");
  const auto request = std::make_shared<CheckRequest>();
  command->add_option("SCENARIO", request->scenario, "scenario file (TOML)");
  command->add_option("--trace", request->trace, "lung volume or flow trace (CSV)");
  command->add_option("--set", request->settings, "key=value, over the scenario; may be repeated")
      ->take_all();
  add_signal_options(*command, request->signal);
  command->add_flag("--keys", request->keys, "list all keys of a scenario with units, limits and defaults");
  command->add_flag("--json", common.json, "print one JSON object");
  command->callback(
      [&common, &run, request] { run = [&common, request] { return check_command(common, *request); }; });
}

}  // namespace trunk
