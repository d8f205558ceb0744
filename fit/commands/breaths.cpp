#include <fmt/format.h>

#include "breaths/mean_breath.hpp"
#include "commands/commands.hpp"
#include "commands/trace_options.hpp"

namespace trunk {
namespace {

struct BreathsRequest {
  std::string trace;
  SignalOptions signal;
};

Exit breaths_command(const Common& common, const BreathsRequest& request) {
  const Segmentation s = segment_breaths(read_signal(request.trace, request.signal));
  Json list = Json::array();
  std::string text = "  breath   onset s    peak s     end s  tidal ml  kept\n";
  int number = 0, kept = 0;
  for (const Breath& b : s.breaths) {
    ++number;
    kept += b.kept ? 1 : 0;
    list.push_back({{"number", number},
                    {"onset_s", b.onset_s},
                    {"peak_s", b.peak_s},
                    {"end_s", b.end_s},
                    {"tidal_volume_ml", 1e6 * b.tidal_volume_m3},
                    {"kept", b.kept},
                    {"reason", b.reason}});
    text += fmt::format("  {:>6} {:>9.2f} {:>9.2f} {:>9.2f} {:>9.0f}  {}\n", number, b.onset_s, b.peak_s,
                        b.end_s, 1e6 * b.tidal_volume_m3, b.kept ? "yes" : "no: " + b.reason);
  }
  for (const std::string& note : s.notes) print_note("note: " + note);
  Json json{{"schema", "trunk.breaths/1"}, {"breaths_found", number}, {"breaths_kept", kept}};
  text += fmt::format("{} breaths found, {} kept", number, kept);
  if (kept > 0) {
    const MeasuredBreath mean = mean_breath(s);
    json["tidal_volume_ml"] = 1e6 * mean.tidal_volume_m3;
    json["inspiration_s"] = mean.inspiration_s;
    json["duration_s"] = mean.duration_s;
    text += fmt::format("; mean: tidal volume {:.0f} ml, inspiration {:.2f} s of {:.2f} s",
                        1e6 * mean.tidal_volume_m3, mean.inspiration_s, mean.duration_s);
  }
  json["breaths"] = list;
  print_result(common, json, text);
  return Exit::done;
}

}  // namespace

void add_breaths(CLI::App& app, Common& common, Run& run) {
  auto* command = app.add_subcommand("breaths", "Show what segmentation makes of a trace");
  const auto request = std::make_shared<BreathsRequest>();
  command->add_option("TRACE", request->trace, "lung volume or flow trace (CSV)")->required();
  add_signal_options(*command, request->signal);
  command->add_flag("--json", common.json, "print one JSON object");
  command->callback(
      [&common, &run, request] { run = [&common, request] { return breaths_command(common, *request); }; });
}

}  // namespace trunk
