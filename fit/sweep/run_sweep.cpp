#include "sweep/run_sweep.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "errors/input_error.hpp"
#include "parallel/workers.hpp"
#include "recording/provenance.hpp"
#include "recording/run_record.hpp"
#include "results/run_file.hpp"
#include "sweep/table.hpp"

namespace trunk {
namespace {

/// What a worker hands back: a run to store, or why there is none.
struct Finished {
  std::size_t run = 0;
  std::optional<RunRecord> record;
  std::string error;
};

Finished simulate_run(const SweepDesign& design, std::size_t run, const Provenance& provenance) {
  try {
    ScenarioFile file = read_scenario(design.scenario_of(run));
    apply_settings(design.settings_of(run), file);
    const Trunk trunk = build_timed_trunk(file);
    const auto stride = std::lround(1e-3 * design.frame_every_ms / file.scenario.time.dt_s);
    const BreathRun result = run_breath(trunk, file.scenario, std::max(1, static_cast<int>(stride)));
    return {run, run_record(file, trunk, result, {}, provenance), ""};
  } catch (const std::exception& error) {
    return {run, std::nullopt, error.what()};
  }
}

SweepRow row_of(const Finished& finished) {
  if (!finished.record) return {"invalid", finished.error, {}, {}, {}};
  const RunRecord& r = *finished.record;
  return {r.status, r.status == "completed" ? "" : r.message, r.measures, r.curve_time_s,
          r.curves.front().values};
}

SweepRow row_of(const RunSummary& s) {
  return {s.status, s.status == "completed" ? "" : s.message, s.measures, s.curve_time_s, s.curve_dV_ml};
}

}  // namespace

SweepOutcome run_sweep(const SweepDesign& design, const SweepFolder& folder, const SweepOptions& options,
                       const SweepProgressNote& note, const std::function<bool()>& cancelled) {
  SweepOutcome outcome;
  outcome.runs = design.runs();
  SweepTable table(design);
  std::vector<std::size_t> todo;
  for (std::size_t run = 0; run < outcome.runs; ++run) {
    if (folder.is_done(run)) {
      table.add(run, folder.run_file_name(run), row_of(read_run_summary(folder.run_file(run))));
      ++outcome.found;
    } else {
      todo.push_back(run);
    }
  }

  std::vector<std::filesystem::path> inputs = design.scenarios;
  inputs.push_back(design.path);
  const Provenance provenance = provenance_of(inputs, options.argv);
  const auto start = std::chrono::steady_clock::now();
  work_off<Finished>(
      todo, options.threads, cancelled,
      [&](std::size_t run) { return simulate_run(design, run, provenance); },
      [&](Finished finished) {
        if (finished.record) write_run(folder.run_file(finished.run), *finished.record);
        table.add(finished.run, finished.record ? folder.run_file_name(finished.run) : "", row_of(finished));
        ++outcome.simulated;
        const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
        const auto left = static_cast<double>(todo.size() - outcome.simulated);
        note(outcome.found + outcome.simulated, outcome.runs,
             left * spent.count() / static_cast<double>(outcome.simulated));
      });
  outcome.finished = outcome.found + outcome.simulated == outcome.runs;
  outcome.failed = table.failures();
  if (outcome.finished) table.write(folder, provenance);
  return outcome;
}

}  // namespace trunk
