#include <fmt/format.h>

#include "commands/commands.hpp"
#include "commands/text/comparison_text.hpp"
#include "records/provenance.hpp"
#include "records/run_record.hpp"
#include "results/read/read_records.hpp"
#include "results/read/results_kind.hpp"
#include "scenarios/build_trunk.hpp"

namespace trunk {
namespace {

struct ReplayRequest {
  std::string file;
  Tolerance tolerance;
};

/// Returns the measured curve that a fit stores beside its best run.
MeasuredCurve measured_beside(const std::string& file) {
  if (kind_of(file) != "fit") return {};
  const FitRecord fit = read_fit(file);
  return {fit.measured_time_s, fit.measured_m3, {}};
}

/// Returns the same simulation, made again from the file alone.
RunRecord simulated_again(const std::string& file, const RunRecord& stored) {
  ScenarioFile scenario = scenario_of_text(stored.scenario_toml, file, stored.trunk_pml);
  const Trunk trunk = build_trunk(scenario);
  const int stride = stored.trajectory.particles == 0 ? 0 : frame_stride(scenario.scenario);
  const BreathRun run = run_breath(trunk, scenario.scenario, stride);
  return run_record(scenario, trunk, run, measured_beside(file), provenance_of({}, ""));
}

Exit replay_command(const Common& common, const ReplayRequest& request) {
  const RunRecord stored = read_run(request.file);
  const RunRecord again = simulated_again(request.file, stored);
  const Comparison c = compare_runs(stored, again, request.tolerance);
  const std::string then = stored.provenance.version + " " + stored.provenance.git_sha,
                    now = again.provenance.version + " " + again.provenance.git_sha;
  Json json{{"schema", "trunk.replay/1"}, {"file", request.file}, {"written_by", then}, {"replayed_by", now}};
  json.update(comparison_json(c));
  const std::string head =
      c.same()
          ? fmt::format("replayed: {} numbers, texts and curves are the same", c.compared)
          : fmt::format("{} of {} differ: stored, replayed, difference", c.differences.size(), c.compared);
  const std::string moved =
      stored.trajectory.particles == 0 ? "" : fmt::format(", particles within {:.2g} m", c.farthest_m);
  print_result(common, json,
               fmt::format("{}: {}{}\n{}  written by trunk {}, replayed by {}", request.file, head, moved,
                           comparison_table(c), then, now));
  return c.same() ? Exit::done : Exit::different;
}

}  // namespace

void add_replay(CLI::App& app, Common& common, Run& run) {
  auto* command = app.add_subcommand("replay",
                                     "Simulates a run, or the best run of a fit, again from its file alone. "
                                     "The exit code is 1 if the result differs.");
  const auto request = std::make_shared<ReplayRequest>();
  command->add_option("FILE", request->file, "A run or a fit (HDF5).")->required();
  add_tolerance_options(*command, request->tolerance);
  add_json_flag(*command, common);
  command->footer(
      "Examples:\n"
      "  trunk replay run.h5\n"
      "  trunk replay fit.h5 --tolerance 1e-9");
  command->callback(
      [&common, &run, request] { run = [&common, request] { return replay_command(common, *request); }; });
}

}  // namespace trunk
