#include "commands/commands.hpp"
#include "results/inspect/print_inspection.hpp"

namespace trunk {

void add_inspect(CLI::App& app, Common& common, Run& run) {
  auto* command = app.add_subcommand("inspect", "Shows what a result file holds.");
  const auto path = std::make_shared<std::string>();
  command->add_option("FILE", *path, "A run, a fit or a sweep (HDF5).")->required();
  add_json_flag(*command, common);
  command->footer("Example:\n  trunk inspect run.h5");
  command->callback([&common, &run, path] {
    run = [&common, path] {
      print_text((common.json ? inspection_json(*path) : inspection_text(*path)) + "\n");
      return Exit::done;
    };
  });
}

}  // namespace trunk
