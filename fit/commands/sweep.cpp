#include <fmt/format.h>

#include "commands/commands.hpp"
#include "sweep/run_sweep.hpp"

namespace trunk {
namespace {

struct SweepRequest {
  std::string design, folder;
  unsigned threads = 0;
};

Exit sweep_command(const Common& common, const SweepRequest& request) {
  const SweepDesign design = read_sweep_design(request.design);
  const SweepFolder folder(request.folder, design, common.force);
  catch_interrupts();
  const auto start = std::chrono::steady_clock::now();
  const SweepOutcome o = run_sweep(
      design, folder, {request.threads, common.argv},
      [](std::size_t done, std::size_t runs, double left_s) {
        print_progress(fmt::format("sweep: {} of {} runs, {:.0f} s left", done, runs, left_s));
      },
      [] { return interrupted(); });
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  if (!o.finished) {
    print_note(fmt::format("interrupted: {} of {} runs are done; the same command goes on from there",
                           o.found + o.simulated, o.runs));
    return Exit::interrupted;
  }
  const Json json{{"schema", "trunk.sweep/1"},
                  {"runs", o.runs},
                  {"found", o.found},
                  {"simulated", o.simulated},
                  {"failed", o.failed},
                  {"table", folder.table_file().string()},
                  {"results", folder.sweep_file().string()},
                  {"wall_s", wall.count()}};
  print_result(
      common, json,
      fmt::format(
          "{}: {} runs, {} found done, {} simulated in {:.1f} s, {} failed\nTable in {}, with curves in {}",
          design.title, o.runs, o.found, o.simulated, wall.count(), o.failed, folder.table_file().string(),
          folder.sweep_file().string()));
  return o.failed == 0 ? Exit::done : Exit::not_converged;
}

Exit status_command(const Common& common, const std::string& folder) {
  const SweepProgress p = progress_of(folder);
  print_result(common,
               {{"schema", "trunk.status/1"}, {"runs", p.runs}, {"done", p.done}, {"has_table", p.has_table}},
               fmt::format("{}: {} of {} runs done, table {}", folder, p.done, p.runs,
                           p.has_table ? "written" : "not written yet"));
  return Exit::done;
}

}  // namespace

void add_sweep(CLI::App& app, Common& common, Run& run) {
  auto* command =
      app.add_subcommand("sweep", "Run scenarios over a grid of parameters; resumes what was interrupted");
  const auto request = std::make_shared<SweepRequest>();
  command->add_option("SWEEP", request->design, "sweep file (TOML)")->required();
  command->add_option("-o,--output", request->folder, "folder for the results")->required();
  command->add_option("-j,--threads", request->threads, "threads [one a core]")->check(CLI::Range(1u, 1024u));
  command->add_flag("--json", common.json, "print one JSON object");
  command->add_flag("--force", common.force, "delete the runs of another sweep in that folder");
  command->callback(
      [&common, &run, request] { run = [&common, request] { return sweep_command(common, *request); }; });
}

void add_status(CLI::App& app, Common& common, Run& run) {
  auto* command = app.add_subcommand("status", "Show how far a sweep is");
  const auto folder = std::make_shared<std::string>();
  command->add_option("DIR", *folder, "folder of a sweep")->required();
  command->add_flag("--json", common.json, "print one JSON object");
  command->callback(
      [&common, &run, folder] { run = [&common, folder] { return status_command(common, *folder); }; });
}

}  // namespace trunk
