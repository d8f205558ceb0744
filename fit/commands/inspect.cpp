#include <fmt/format.h>

#include "commands/commands.hpp"
#include "results/inspect/print_inspection.hpp"

namespace trunk {

void add_inspect(CLI::App& app, Common& common, Run& run) {
  auto* command = app.add_subcommand("inspect", "Show what a result file holds");
  const auto path = std::make_shared<std::string>();
  command->add_option("FILE", *path, "run, fit or sweep (HDF5)")->required();
  command->add_flag("--json", common.json, "print one JSON object");
  command->callback([&common, &run, path] {
    run = [&common, path] {
      fmt::print("{}\n", common.json ? inspection_json(*path) : inspection_text(*path));
      return Exit::done;
    };
  });
}

}  // namespace trunk
