#include <fmt/format.h>

#include <charconv>

#include "commands/commands.hpp"
#include "errors/input_error.hpp"
#include "sweep/progress.hpp"
#include "sweep/run_sweep.hpp"
#include "sweep/table.hpp"

namespace trunk {
namespace {

struct SweepRequest {
  std::string design, folder, shard;
  SweepOptions options;
};

/// Returns the shard that "k/n" names; throws InputError.
Shard shard_of(const std::string& text) {
  if (text.empty()) return {};
  Shard shard;
  const char* end = text.data() + text.size();
  const auto number = std::from_chars(text.data(), end, shard.number);
  const bool slash = number.ec == std::errc() && number.ptr < end && *number.ptr == '/';
  const auto count = slash ? std::from_chars(number.ptr + 1, end, shard.count) : number;
  if (!slash || count.ec != std::errc() || count.ptr != end || shard.number < 1 ||
      shard.number > shard.count || shard.count > 1'000'000)
    throw InputError(Place{"--shard " + text}, "is not a part of a sweep",
                     "K/N with K from 1 to N, as in --shard 3/16");
  return shard;
}

std::string duration(double seconds) {
  if (seconds < 100) return fmt::format("{:.0f} s", seconds);
  return seconds < 6000 ? fmt::format("{:.0f} min", seconds / 60) : fmt::format("{:.1f} h", seconds / 3600);
}

void show_progress(std::size_t done, std::size_t runs, double runs_per_s) {
  print_progress(fmt::format("sweep: {} of {} runs, {:.4g} a second, {} left", done, runs, runs_per_s,
                             duration(static_cast<double>(runs - done) / runs_per_s)));
}

std::string place_of_table(const SweepFolder& folder, const SweepDesign& design) {
  return fmt::format("Table in {}{} {}", folder.table_file().string(),
                     design.store == SweepDesign::Store::summary ? " and" : ", with curves in",
                     folder.sweep_file().string());
}

Exit sweep_command(const Common& common, SweepRequest request) {
  SweepOptions& options = request.options;
  options.shard = shard_of(request.shard);
  options.argv = common.argv;
  const SweepDesign design = read_sweep_design(request.design);
  const SweepFolder folder(request.folder, design, options.shard, common.force);
  if (design.intervals && design.draws > 0)
    print_note(
        fmt::format("note: each run of a subject that was fitted is simulated with up to {} draws of its "
                    "fit, so that its "
                    "row has intervals; [output] intervals = false in the sweep file leaves them out",
                    design.draws));
  catch_interrupts();
  const auto start = std::chrono::steady_clock::now();
  const SweepOutcome o = run_sweep(design, folder, options, &show_progress, [] { return interrupted(); });
  if (!o.finished) {
    print_note(fmt::format("interrupted: {} of {} runs are done; the same command does the rest",
                           o.found + o.simulated, o.runs));
    return Exit::interrupted;
  }
  const bool whole = options.shard.count == 1;
  if (whole) write_table(design, folder, common.argv);
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  Json json{{"schema", "trunk.sweep/1"}, {"runs", o.runs},     {"found", o.found},
            {"simulated", o.simulated},  {"failed", o.failed}, {"wall_s", wall.count()}};
  if (whole) {
    json["table"] = folder.table_file().string();
    json["results"] = folder.sweep_file().string();
  } else {
    json["shard"] = request.shard;
  }
  const std::string next =
      whole ? place_of_table(folder, design)
            : fmt::format("This was shard {}; `trunk merge {}` writes the table when all shards have ended",
                          request.shard, folder.path().string());
  print_result(common, json,
               fmt::format("{}: {} runs, {} found done, {} simulated in {:.1f} s, {} failed\n{}",
                           design.title, o.runs, o.found, o.simulated, wall.count(), o.failed, next));
  return o.failed == 0 ? Exit::done : Exit::not_converged;
}

Exit status_command(const Common& common, const std::string& folder) {
  const SweepProgress p = progress_of(folder);
  print_result(common,
               {{"schema", "trunk.status/1"},
                {"runs", p.runs},
                {"done", p.done},
                {"failed", p.failed},
                {"left", p.runs - p.done},
                {"runs_per_s", p.runs_per_s},
                {"has_table", p.has_table}},
               fmt::format("{}: {} of {} runs done, {} of them failed, {} left, {:.4g} a second, table {}",
                           folder, p.done, p.runs, p.failed, p.runs - p.done, p.runs_per_s,
                           p.has_table ? "written" : "not written yet"));
  return Exit::done;
}

Exit merge_command(const Common& common, const std::string& path) {
  const SweepFolder folder(path);
  const SweepDesign design = folder.design();
  const TableOutcome o = write_table(design, folder, common.argv);
  if (o.missing > 0)
    print_note(fmt::format("note: {} of {} runs are missing, because their shards have not ended", o.missing,
                           o.runs));
  print_result(common,
               {{"schema", "trunk.merge/1"},
                {"runs", o.runs},
                {"failed", o.failed},
                {"missing", o.missing},
                {"table", folder.table_file().string()},
                {"results", folder.sweep_file().string()}},
               fmt::format("{} runs, {} failed, {} missing\n{}", o.runs, o.failed, o.missing,
                           place_of_table(folder, design)));
  return o.failed + o.missing == 0 ? Exit::done : Exit::not_converged;
}

/// Adds `status` or `merge`, which take a folder and nothing else.
void add_folder_command(CLI::App& app, Common& common, Run& run, const char* name, const char* what,
                        Exit (*carry_out)(const Common&, const std::string&)) {
  auto* command = app.add_subcommand(name, what);
  const auto folder = std::make_shared<std::string>();
  command->add_option("DIR", *folder, "The folder of the sweep.")->required();
  add_json_flag(*command, common);
  command->footer(fmt::format("Example:\n  trunk {} grid", name));
  command->callback([&common, &run, folder, carry_out] {
    run = [&common, folder, carry_out] { return carry_out(common, *folder); };
  });
}

}  // namespace

void add_sweep(CLI::App& app, Common& common, Run& run) {
  auto* command = app.add_subcommand("sweep",
                                     "Simulates scenarios over a grid or a sample of parameters. After an "
                                     "interruption, run the same command to resume.");
  const auto request = std::make_shared<SweepRequest>();
  SweepOptions& options = request->options;
  command->add_option("SWEEP", request->design, "The sweep file (TOML).")->required();
  command->add_option("-o,--output", request->folder, "Writes the results to this folder.")
      ->type_name("DIR")
      ->required();
  command->add_option("-j,--threads", options.threads, "Uses this many threads. [one per core]")
      ->check(whole_number(1, 1024));
  command
      ->add_option("--shard", request->shard,
                   "Does part K of N: runs K, K+N, K+2N and so on. N processes can then share the work and "
                   "the folder; `trunk merge` writes the table at the end.")
      ->type_name("K/N");
  command->add_option("--timeout", options.timeout_s, "Stops a run that takes longer than this. [never]")
      ->type_name("SECONDS")
      ->check(within(1e-3, 1e9));
  command->add_flag("--retry-failed", options.retry_failed,
                    "Simulates again what failed or timed out before.");
  add_json_flag(*command, common);
  command->add_flag("--force", common.force, "Deletes the runs of another sweep in the folder.");
  command->footer(
      "Examples:\n"
      "  trunk sweep scenarios/sweep_grid.toml -o grid -j 4\n"
      "  trunk sweep scenarios/sweep_grid.toml -o grid --shard 3/16");
  command->callback(
      [&common, &run, request] { run = [&common, request] { return sweep_command(common, *request); }; });
}

void add_status(CLI::App& app, Common& common, Run& run) {
  add_folder_command(app, common, run, "status", "Shows how far a sweep is.", &status_command);
}

void add_merge(CLI::App& app, Common& common, Run& run) {
  add_folder_command(app, common, run, "merge", "Writes the table of a sweep that was done in shards.",
                     &merge_command);
}

}  // namespace trunk
