#include <fmt/format.h>

#include "commands/commands.hpp"
#include "commands/text/comparison_text.hpp"
#include "errors/input_error.hpp"
#include "results/read/read_records.hpp"
#include "results/read/results_kind.hpp"

namespace trunk {
namespace {

struct DiffRequest {
  std::string first, second;
  Tolerance tolerance;
};

Comparison compare_files(const DiffRequest& request) {
  const std::string kind = kind_of(request.first), other = kind_of(request.second);
  if (kind == "sweep") throw InputError(Place{request.first}, "is a sweep", "a run or a fit");
  if (other != kind)
    throw InputError(Place{request.second}, "is a " + other, "a " + kind + ", like the first file");
  return kind == "run" ? compare_runs(read_run(request.first), read_run(request.second), request.tolerance)
                       : compare_fits(read_fit(request.first), read_fit(request.second), request.tolerance);
}

Exit diff_command(const Common& common, const DiffRequest& request) {
  const Comparison c = compare_files(request);
  Json json{{"schema", "trunk.diff/1"}, {"first", request.first}, {"second", request.second}};
  json.update(comparison_json(c));
  const std::string head =
      c.same() ? fmt::format("the same: {} numbers, texts and curves", c.compared)
               : fmt::format("{} of {} differ: first, second, difference", c.differences.size(), c.compared);
  print_result(common, json,
               fmt::format("{} and {}: {}\n{}", request.first, request.second, head, comparison_table(c)));
  return c.same() ? Exit::done : Exit::different;
}

}  // namespace

void add_diff(CLI::App& app, Common& common, Run& run) {
  auto* command =
      app.add_subcommand("diff", "Compares two runs or two fits. The exit code is 1 if they differ.");
  const auto request = std::make_shared<DiffRequest>();
  command->add_option("FIRST", request->first, "A run or a fit (HDF5).")->required();
  command->add_option("SECOND", request->second, "Another file of the same kind.")->required();
  add_tolerance_options(*command, request->tolerance);
  add_json_flag(*command, common);
  command->footer(
      "Examples:\n"
      "  trunk diff before.h5 after.h5\n"
      "  trunk diff before.h5 after.h5 --tolerance 0.001");
  command->callback(
      [&common, &run, request] { run = [&common, request] { return diff_command(common, *request); }; });
}

}  // namespace trunk
