#include "sweep/run_sweep.hpp"

#include <algorithm>
#include <chrono>

#include "parallel/workers.hpp"
#include "records/provenance.hpp"
#include "results/read/results_kind.hpp"
#include "results/write/write_run.hpp"
#include "sweep/simulator.hpp"

namespace trunk {
namespace {

enum class RunState : char { open, completed, failed };

/// The states of all runs without their rows, which would take much memory.
class RunStates {
 public:
  explicit RunStates(std::size_t runs) : states_(runs, RunState::open) {}

  void note(const SweepRow& row) {
    states_[row.run] = row.status == "completed" ? RunState::completed : RunState::failed;
  }
  void reopen(std::size_t run) { states_[run] = RunState::open; }
  RunState operator[](std::size_t run) const { return states_[run]; }

 private:
  std::vector<RunState> states_;
};

/// Returns the states from rows and files. A crash can leave a file without its row, which is then added; a
/// row without its file is not done.
RunStates states_in(const SweepDesign& design, const SweepFolder& folder, const SweepOptions& options,
                    Journal& journal) {
  RunStates states(design.runs());
  std::vector<char> has_file(design.runs(), 0);
  folder.for_each_row([&](const SweepRow& row) {
    states.note(row);
    has_file[row.run] = row.has_file ? 1 : 0;
  });
  for (std::size_t run = 0; run < design.runs(); ++run) {
    if (!options.shard.has(run)) continue;
    const auto file = folder.run_file(run);
    if (has_file[run] && !is_complete(file)) states.reopen(run);
    if (design.store == SweepDesign::Store::full && states[run] == RunState::open && is_complete(file)) {
      const SweepRow row = row_of(run, read_stored_run(file));
      journal.append({&row, 1});
      states.note(row);
    }
    if (options.retry_failed && states[run] == RunState::failed) states.reopen(run);
  }
  return states;
}

/// Returns the runs ordered by model, in batches of at most `together` runs of one model.
std::vector<std::vector<std::size_t>> in_batches(const SweepDesign& design, std::vector<std::size_t> runs,
                                                 std::size_t together) {
  std::stable_sort(runs.begin(), runs.end(),
                   [&](std::size_t a, std::size_t b) { return design.model_of(a) < design.model_of(b); });
  std::vector<std::vector<std::size_t>> batches;
  for (const std::size_t run : runs) {
    const bool joins = !batches.empty() && batches.back().size() < together &&
                       design.model_of(batches.back().front()) == design.model_of(run);
    if (!joins) batches.emplace_back();
    batches.back().push_back(run);
  }
  return batches;
}

}  // namespace

SweepOutcome run_sweep(const SweepDesign& design, const SweepFolder& folder, const SweepOptions& options,
                       const SweepProgressNote& note, const std::function<bool()>& cancelled) {
  Journal journal = folder.journal(options.shard);
  RunStates states = states_in(design, folder, options, journal);
  SweepOutcome outcome;
  const auto open_runs = [&] {
    std::vector<std::size_t> open;
    for (std::size_t run = options.shard.number - 1; run < design.runs(); run += options.shard.count)
      if (states[run] == RunState::open) open.push_back(run);
    return open;
  };
  for (std::size_t run = 0; run < design.runs(); ++run) outcome.runs += options.shard.has(run);
  outcome.found = outcome.runs - open_runs().size();

  Provenance provenance = provenance_of({}, options.argv);
  provenance.input_sha256 = folder.inputs();
  const SweepSimulator simulator(design, provenance, {options.timeout_s, cancelled, options.clock_s});
  const auto start = std::chrono::steady_clock::now();
  const auto keep = [&](std::vector<FinishedRun> finished) {
    if (finished.empty()) return;  // the batch took too long, so each of its runs is tried alone later
    std::vector<SweepRow> rows;
    for (FinishedRun& f : finished) {
      if (f.record) write_run(folder.run_file(f.row.run), *f.record);
      states.note(f.row);
      rows.push_back(std::move(f.row));
    }
    journal.append(rows);
    outcome.simulated += rows.size();
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
    note(outcome.found + outcome.simulated, outcome.runs,
         static_cast<double>(outcome.simulated) / spent.count());
  };
  for (const std::size_t together :
       {simulator.together(), std::size_t{1}}) {  // then alone, if a batch took too long
    if (cancelled && cancelled()) break;
    const auto batches = in_batches(design, open_runs(), together);
    std::vector<std::size_t> items(batches.size());
    for (std::size_t i = 0; i < items.size(); ++i) items[i] = i;
    work_off<std::vector<FinishedRun>>(
        items, options.threads, cancelled, [&](std::size_t i) { return simulator(batches[i]); }, keep);
  }
  journal.synchronise();
  outcome.finished = outcome.found + outcome.simulated == outcome.runs;
  for (std::size_t run = 0; run < design.runs(); ++run)
    if (options.shard.has(run) && states[run] == RunState::failed) ++outcome.failed;
  return outcome;
}

}  // namespace trunk
