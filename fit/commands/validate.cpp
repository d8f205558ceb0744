#include <fmt/format.h>

#include "commands/commands.hpp"
#include "commands/options/shipped_files.hpp"
#include "commands/text/validation_text.hpp"
#include "validation/usual_ranges.hpp"

namespace trunk {
namespace {

struct ValidateRequest {
  std::string scenarios, table1;
};

Json row_json(const char* name, const auto& value_of) {
  Json json{{"name", name}};
  for (const Table1Column& column : table1_columns()) json[std::string(column.measure)] = value_of(column);
  return json;
}

Json breath_json(const ValidatedScenario& scenario, const ValidatedBreath& breath) {
  return {{"scenario", scenario.name},
          {"status", breath.status},
          {"message", breath.message},
          {"start", breath.start == Start::rest ? "rest" : "periodic"},
          {"delta_v_ml", json_number(breath.row.dv_ml)},
          {"excursion_left_mm", json_number(breath.left_dome_mm)},
          {"excursion_right_mm", json_number(breath.right_dome_mm)},
          {"excursion_left_most_risen_mm", json_number(breath.left_most_risen_mm)},
          {"excursion_right_most_risen_mm", json_number(breath.right_most_risen_mm)},
          {"max_relative_volume_error", json_number(breath.volume_error)}};
}

/// Returns what only a breath with a lung has.
Json pressures_json(const ValidatedScenario& scenario, const ValidatedBreath& breath) {
  Json json{{"scenario", scenario.name}};
  for (const UsualRange& r : usual_ranges()) json[std::string(r.measure)] = json_number(breath.*r.value);
  return json;
}

Json range_json(const UsualRange& r) {
  return {{"name", r.measure}, {"low", r.low}, {"high", r.high}, {"unit", r.unit}, {"source", r.source}};
}

Json bound_json(const Judged& r) {
  return {{"name", r.bound.name},
          {"value", json_number(r.value)},
          {"low", json_number(r.bound.low)},
          {"high", json_number(r.bound.high)},
          {"limits_allowed", !r.bound.open},
          {"unit", r.bound.unit},
          {"pass", r.pass}};
}

Json validation_summary(const ValidationRun& f, std::span<const Judged> results, bool valid,
                        const ValidateRequest& request) {
  Json json{{"schema", "trunk.validate/1"},   {"status", valid ? "valid" : "not_valid"},
            {"scenarios", request.scenarios}, {"table1", request.table1},
            {"rows", Json::array()},          {"errors", Json::array()},
            {"breaths", Json::array()},       {"pressures", Json::array()},
            {"usual", Json::array()},         {"bounds", Json::array()}};
  for (const Table1Source& source : table1_rows(f)) {
    json["rows"].push_back(row_json(
        source.name, [&](const Table1Column& column) { return json_number(source.row->*column.value); }));
    if (source.row != &f.paper.experiment)
      json["errors"].push_back(row_json(source.name, [&](const Table1Column& column) {
        const Table1Error error = error_of(column, *source.row, f.paper.experiment);
        return Json{{"value", json_number(error.value)}, {"unit", error.relative ? "percent" : column.unit}};
      }));
  }
  for (const ValidatedScenario& scenario : validated_scenarios()) {
    const ValidatedBreath& breath = f.*scenario.breath;
    json["breaths"].push_back(breath_json(scenario, breath));
    if (breath.lung) json["pressures"].push_back(pressures_json(scenario, breath));
  }
  for (const UsualRange& r : usual_ranges()) json["usual"].push_back(range_json(r));
  for (const Judged& r : results) json["bounds"].push_back(bound_json(r));
  return json;
}

/// Returns why numbers are missing if a simulation did not end.
std::string unfinished_text(const ValidationRun& f) {
  std::string text;
  for (const ValidatedScenario& scenario : validated_scenarios()) {
    const ValidatedBreath& breath = f.*scenario.breath;
    if (breath.status != "completed") text += fmt::format("; {}: {}", scenario.name, breath.message);
  }
  return text;
}

Exit validate_command(const Common& common, ValidateRequest request) {
  if (request.scenarios.empty()) request.scenarios = shipped_file("scenarios", "--scenarios").string();
  if (request.table1.empty()) request.table1 = shipped_file("reference/table1.csv", "--table1").string();
  const ValidationRun run =
      run_validation(request.table1, require_folder(request.scenarios),
                     [](std::string_view name) { print_progress(fmt::format("validate: {}", name)); });
  const std::vector<Judged> results = judged(run);
  const std::string failures = failures_text(results);
  print_result(common, validation_summary(run, results, failures.empty(), request),
               validation_text(run, results));
  if (failures.empty()) return Exit::done;
  print_error(failures + unfinished_text(run));
  return Exit::not_converged;
}

}  // namespace

void add_validate(CLI::App& app, Common& common, Run& run) {
  auto* command = app.add_subcommand(
      "validate", "Compares the simulator with Table 1 of the paper and with paralysis. It writes no file.");
  const auto request = std::make_shared<ValidateRequest>();
  command
      ->add_option("--scenarios", request->scenarios,
                   "Takes the scenarios from this folder. [scenarios, beside the folder of the program, else "
                   "in this folder]")
      ->type_name("DIR");
  command
      ->add_option("--table1", request->table1,
                   "Takes the paper's numbers from this file (CSV). [reference/table1.csv, found in the same "
                   "way]")
      ->type_name("FILE");
  add_json_flag(*command, common);
  std::string names;
  for (const ValidatedScenario& scenario : validated_scenarios())
    names += (names.empty() ? "" : ", ") + std::string(scenario.name);
  command->footer(
      "It simulates " + names +
      ". It prints Table 1 (experiment, published model, ours), the errors, the domes, the pressures of "
      "trunks with a lung beside usual ones, and every bound with its value. The exit code is 3 if a bound "
      "does not hold or a simulation does not end.\n\n"
      "Example:\n"
      "  trunk validate");
  command->callback(
      [&common, &run, request] { run = [&common, request] { return validate_command(common, *request); }; });
}

}  // namespace trunk
