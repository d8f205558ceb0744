#include <fmt/format.h>

#include <system_error>

#include "commands/commands.hpp"
#include "errors/input_error.hpp"
#include "io/region_loads_lml.hpp"
#include "io/scenario_file.hpp"
#include "io/trunk_pml.hpp"
#include "results/summary.hpp"
#include "results/target_file.hpp"

namespace trunk {
namespace {

namespace fs = std::filesystem;

struct ExportRequest {
  std::string file, pml_folder;
};

struct TextFile {
  fs::path path;
  std::string text;
};

/// The trunk, its loads where it has any, and the scenario that takes both: simulating it repeats the run.
std::vector<TextFile> pml_files(const std::string& source, const fs::path& folder) {
  const RunInputs inputs = read_run_inputs(source);
  Scenario s = scenario_of_text(inputs.scenario_toml, source, inputs.trunk_pml).scenario;
  std::vector<TextFile> files{{folder / "trunk.pml", trunk_pml(s)}};
  s.mesh_file = "trunk.pml";
  std::string head;
  if (!s.loads.empty()) {
    files.push_back({folder / "loads.lml", region_loads_lml(s.loads)});
    head = "loads = \"loads.lml\"\n";
    s.loads.clear();
  }
  files.push_back({folder / "scenario.toml", head + to_toml(s)});
  return files;
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw InputError(folder.string(), 0, "cannot be made a folder: " + error.message());
}

Exit export_command(const Common& common, const ExportRequest& request) {
  if (request.pml_folder.empty()) throw CLI::RequiredError("--pml DIR");
  const std::vector<TextFile> files = pml_files(request.file, request.pml_folder);
  make_folder(request.pml_folder);
  for (const TextFile& file : files) {
    require_apart({request.file}, {file.path});
    require_writable_target(file.path, common.force);
  }
  Json names = Json::array();
  std::string text = "Written:";
  for (const TextFile& file : files) {
    replace_file(file.path, std::as_bytes(std::span(file.text)));
    names.push_back(file.path.string());
    text += " " + file.path.string();
  }
  text += fmt::format("\nSimulate it again: trunk simulate {} -o again.h5", files.back().path.string());
  print_result(common, {{"schema", "trunk.export/1"}, {"files", names}}, text);
  return Exit::done;
}

}  // namespace

void add_export(CLI::App& app, Common& common, Run& run) {
  auto* command =
      app.add_subcommand("export", "Write what a run or fit was made of in formats of other programs");
  const auto request = std::make_shared<ExportRequest>();
  command->add_option("FILE", request->file, "run or fit (HDF5); of a fit its best run")->required();
  command->add_option("--pml", request->pml_folder,
                      "folder for trunk.pml (CamiTK's physical model: particles, surfaces, regions, fibres), "
                      "loads.lml where there are loads, and scenario.toml, which simulates them again");
  command->add_flag("--json", common.json, "print one JSON object");
  command->add_flag("--force", common.force, "replace files that exist");
  command->callback(
      [&common, &run, request] { run = [&common, request] { return export_command(common, *request); }; });
}

}  // namespace trunk
