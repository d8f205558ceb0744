#include <span>

#include "commands/commands.hpp"
#include "commands/options/breath_options.hpp"
#include "commands/options/trace_options.hpp"
#include "commands/text/breath_table.hpp"
#include "files/replace_file.hpp"

namespace trunk {
namespace {

struct BreathsRequest {
  std::string trace, csv;
  SignalOptions signal;
  BreathSelection selection;
  bool curve = false;
};

Exit breaths_command(const Common& common, const BreathsRequest& request) {
  if (!request.csv.empty()) {
    require_apart({request.trace}, {request.csv});
    require_writable_output(request.csv, common.force);
  }
  const Segmentation s = segment_breaths(read_signal(request.trace, request.signal), request.selection);
  if (!request.csv.empty()) {
    const std::string csv = breaths_csv(s);
    replace_file(request.csv, std::as_bytes(std::span(csv)));
  }
  for (const std::string& note : s.notes) print_note("note: " + note);
  Json json = breaths_json(s);
  if (request.curve) json["curve"] = curve_json(s);
  print_result(common, json, breaths_text(s));
  return Exit::done;
}

}  // namespace

void add_breaths(CLI::App& app, Common& common, Run& run) {
  auto* command = app.add_subcommand("breaths", "Show what segmentation makes of a trace");
  const auto request = std::make_shared<BreathsRequest>();
  command->add_option("TRACE", request->trace, "trace of volume, flow or belt (text table, MATLAB, EDF, BDF)")
      ->required();
  add_signal_options(*command, request->signal);
  add_breath_options(*command, request->selection);
  command->add_option("--csv", request->csv, "also write the breaths as a table");
  command->add_flag("--curve", request->curve, "add to --json the volume without drift, 50 samples a second");
  command->add_flag("--json", common.json, "print one JSON object");
  command->add_flag("--force", common.force, "replace the table if it exists");
  command->callback(
      [&common, &run, request] { run = [&common, request] { return breaths_command(common, *request); }; });
}

}  // namespace trunk
