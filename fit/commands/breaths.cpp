#include <algorithm>
#include <span>

#include "channels/read_breaths.hpp"
#include "clinic/clinic.hpp"
#include "commands/commands.hpp"
#include "commands/options/breath_options.hpp"
#include "commands/options/trace_options.hpp"
#include "commands/text/breath_table.hpp"
#include "files/replace_file.hpp"
#include "gates/gates.hpp"

namespace trunk {
namespace {

struct BreathsRequest {
  std::string trace, csv;
  SignalOptions signal;
  BreathSelection selection;
  ClinicOptions clinic;
  bool curve = false;
};

/// Returns what the channels of the kept breaths give; nothing if there are none.
std::vector<ClinicNumber> numbers_of(const Segmentation& s, const ClinicOptions& options) {
  const bool kept = std::any_of(s.breaths.begin(), s.breaths.end(), [](const Breath& b) { return b.kept; });
  if (s.channels.empty() || !s.calibrated || !kept) return {};
  return clinic_numbers(mean_breath(s), options);
}

Exit breaths_command(const Common& common, const BreathsRequest& request) {
  if (!request.csv.empty()) {
    require_apart({request.trace}, {request.csv});
    require_writable_output(request.csv, common.force);
  }
  const Segmentation s = read_breaths(request.trace, request.signal, request.selection);
  const std::vector<ClinicNumber> clinic = numbers_of(s, request.clinic);
  if (!request.csv.empty()) {
    const std::string csv = breaths_csv(s, clinic);
    replace_file(request.csv, std::as_bytes(std::span(csv)));
  }
  Json json = breaths_json(s, clinic);
  const Screening screening = screened(s, std::nullopt);
  json["gates"] = Json::array();
  for (const Gate& gate : screening.gates) {
    json["gates"].push_back(gate.name);
    json["notes"].push_back(gate.sentence);
  }
  for (const std::string& note : screening.notes) json["notes"].push_back(note);
  for (const Json& note : json["notes"]) print_note("note: " + note.get<std::string>());
  if (request.curve) json["curve"] = curve_json(s);
  print_result(common, json, breaths_text(s, clinic));
  return Exit::done;
}

}  // namespace

void add_breaths(CLI::App& app, Common& common, Run& run) {
  auto* command = app.add_subcommand(
      "breaths",
      "Shows the breaths that the program finds in a recording. For a rejected breath it says why.");
  const auto request = std::make_shared<BreathsRequest>();
  command
      ->add_option("TRACE", request->trace,
                   "A recording of volume, flow or a belt: a text table, MATLAB, EDF or BDF file.")
      ->required();
  add_signal_options(*command, request->signal);
  add_clinic_options(*command, request->clinic);
  add_breath_options(*command, request->selection);
  command->add_option("--csv", request->csv, "Also writes the breaths to this file, as a table.")
      ->type_name("FILE");
  command->add_flag("--curve", request->curve,
                    "Adds the volume without drift to the JSON object, 50 samples a second.");
  add_json_flag(*command, common);
  add_force_flag(*command, common, "Replaces the table if it exists.");
  command->footer(
      "Examples:\n"
      "  trunk breaths recording.csv\n"
      "  trunk breaths recording.csv --flow \"Resp flow\" --unit L/min --exclude 3,7-9\n"
      "  trunk breaths recording.csv --poes Pes --pga Pga --pressure-unit kPa");
  command->callback(
      [&common, &run, request] { run = [&common, request] { return breaths_command(common, *request); }; });
}

}  // namespace trunk
