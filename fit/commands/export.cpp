#include <fmt/format.h>

#include <system_error>

#include "commands/commands.hpp"
#include "errors/input_error.hpp"
#include "exports/csv_tables.hpp"
#include "exports/vtk_files.hpp"
#include "files/replace_file.hpp"
#include "results/read/read_records.hpp"
#include "results/read/results_kind.hpp"
#include "results/read/stored_run.hpp"
#include "results/write/vtkhdf_view.hpp"
#include "scenarios/read_scenario.hpp"
#include "trunks/read_trunk_pml.hpp"
#include "trunks/region_loads_lml.hpp"

namespace trunk {
namespace {

namespace fs = std::filesystem;

struct ExportRequest {
  std::string file, pml_folder, csv_folder, vtk_folder;
};

/// Returns the trunk, its loads if there are any, and the scenario that reads both. Simulating the scenario
/// repeats the run.
std::vector<NamedText> pml_files(const std::string& source) {
  const RunInputs inputs = read_run_inputs(source);
  Scenario s = scenario_of_text(inputs.scenario_toml, source, inputs.trunk_pml).scenario;
  std::vector<NamedText> files{{"trunk.pml", trunk_pml(s)}};
  s.mesh_file = "trunk.pml";
  std::string head;
  if (!s.loads.empty()) {
    files.push_back({"loads.lml", region_loads_lml(s.loads)});
    head = "loads = \"loads.lml\"\n";
    s.loads.clear();
  }
  files.push_back({"scenario.toml", head + to_toml(s)});
  return files;
}

std::vector<NamedText> csv_files(const std::string& source) {
  return kind_of(source) == "fit" ? csv_tables(read_fit(source)) : csv_tables(read_run(source));
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw InputError(Place{folder.string()}, "the folder cannot be made: " + error.message());
}

/// Writes all files and, if `view` is not empty, a view of VTKHDF, and returns their names. Throws InputError
/// before it writes any if one of them cannot be written.
std::vector<std::string> write_all(const Common& common, const std::string& source, const fs::path& folder,
                                   const std::vector<NamedText>& files, const fs::path& view) {
  make_folder(folder);
  std::vector<fs::path> paths;
  for (const NamedText& file : files) paths.push_back(folder / file.name);
  if (!view.empty()) paths.push_back(view);
  for (const fs::path& path : paths) {
    make_folder(path.parent_path());
    require_apart({source}, {path});
    require_writable_output(path, common.force);
  }
  for (std::size_t i = 0; i < files.size(); ++i)
    replace_file(paths[i], std::as_bytes(std::span(files[i].text)));
  if (!view.empty()) write_vtkhdf_view(view, source);
  std::vector<std::string> names;
  for (const fs::path& path : paths) names.push_back(path.string());
  return names;
}

Exit export_command(const Common& common, const ExportRequest& request) {
  if (request.pml_folder.empty() && request.csv_folder.empty() && request.vtk_folder.empty())
    throw InputError(Place{}, "no format is given", "--csv DIR, --vtk DIR or --pml DIR");
  std::vector<std::string> names;
  std::string advice;
  const auto write = [&](const fs::path& folder, const std::vector<NamedText>& files, const fs::path& view) {
    for (std::string& name : write_all(common, request.file, folder, files, view))
      names.push_back(std::move(name));
  };
  if (const fs::path folder = request.pml_folder; !folder.empty()) {
    write(folder, pml_files(request.file), "");
    advice += fmt::format("\nSimulate it again: trunk simulate {} -o again.h5",
                          (folder / "scenario.toml").string());
  }
  if (const fs::path folder = request.csv_folder; !folder.empty()) write(folder, csv_files(request.file), "");
  if (const fs::path folder = request.vtk_folder; !folder.empty()) {
    write(folder, vtk_files(read_run(request.file).trajectory, request.file), folder / "view.vtkhdf");
    advice += fmt::format("\nOpen in ParaView: {}, or from 5.12 on {}", (folder / "trunk.pvd").string(),
                          (folder / "view.vtkhdf").string());
  }
  constexpr std::size_t most_named = 12;
  std::string text = "Written:";
  for (std::size_t i = 0; i < std::min(most_named, names.size()); ++i) text += " " + names[i];
  if (names.size() > most_named) text += fmt::format(" and {} more", names.size() - most_named);
  print_result(common, {{"schema", "trunk.export/1"}, {"files", names}}, text + advice);
  return Exit::done;
}

}  // namespace

void add_export(CLI::App& app, Common& common, Run& run) {
  auto* command = app.add_subcommand(
      "export", "Writes a run or a fit in formats that other programs read. Each format goes to a folder.");
  const auto request = std::make_shared<ExportRequest>();
  command
      ->add_option("FILE", request->file,
                   "A run or a fit (HDF5). For a fit, this command writes the best run.")
      ->required();
  command
      ->add_option(
          "--csv", request->csv_folder,
          "Writes tables to this folder: curves, frames, positions, measures, parameters. A fit also "
          "has tables of the breath, evaluations, profiles and surface.")
      ->type_name("DIR");
  command
      ->add_option("--vtk", request->vtk_folder,
                   "Writes trunk.pvd and frames/*.vtp to this folder, for every ParaView, and view.vtkhdf, "
                   "for ParaView 5.12 and later. view.vtkhdf is a link to FILE.")
      ->type_name("DIR");
  command
      ->add_option("--pml", request->pml_folder,
                   "Writes trunk.pml to this folder (CamiTK's physical model: particles, surfaces, regions, "
                   "fibres), loads.lml if there are loads, and scenario.toml, which simulates them again.")
      ->type_name("DIR");
  add_json_flag(*command, common);
  add_force_flag(*command, common, "Replaces files that exist.");
  command->footer(
      "Examples:\n"
      "  trunk export run.h5 --csv tables\n"
      "  trunk export run.h5 --vtk paraview --pml camitk");
  command->callback(
      [&common, &run, request] { run = [&common, request] { return export_command(common, *request); }; });
}

}  // namespace trunk
