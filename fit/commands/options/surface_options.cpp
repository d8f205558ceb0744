#include "commands/options/surface_options.hpp"

#include "commands/text/output.hpp"
#include "results/read/read_records.hpp"

namespace trunk {

void add_surface_options(CLI::App& command, SurfaceOptions& options) {
  command
      .add_option("--surface-unit", options.unit, "unit of the surface: mm, cm or m [guessed from its size]")
      ->check(CLI::IsMember({"mm", "cm", "m"}));
  command.add_option(
      "--axes", options.axes,
      "sides to which x, y and z of the surface grow, as in LPS or RSA, or its coordinates that "
      "are right, forward and up, as in x,-z,y [guessed]");
  command.add_option("--component", options.component,
                     "the one component, group or solid of the file to take [all]");
}

CLI::Option* add_surface_request(CLI::App& command, SurfaceRequest& request) {
  auto* surface =
      command.add_option("--surface", request.surface, "measured surface (STL, OBJ, PLY, VTK, VTP or PML)");
  command.add_option("--at", request.at, "peak (largest lung volume), start, end, or seconds [peak]");
  command.add_option(
      "--region", request.region,
      "diaphragm, lung, abdomen, skin, or a region of the run such as central_tendon [diaphragm]");
  add_surface_options(command, request.options);
  command.add_flag("--align", request.align, "first move the surface rigidly onto the region");
  return surface;
}

SurfaceAnswer compared(const SurfaceRequest& request, const std::string& run_file) {
  SurfaceAnswer answer{read_surface(request.surface, request.options), {}};
  const RunRecord run = read_run(run_file);
  ComparedSurface& beside = answer.beside;
  beside.surface = std::move(answer.file.surface);
  beside.region =
      region_at(request.region, moment_of(request.at, run.trajectory, run_file), run.trajectory, run_file);
  for (const std::string& note : answer.file.notes) print_note("note: " + request.surface + ": " + note);
  beside.comparison = compare_shape(beside.region, beside.surface, request.align);
  return answer;
}

}  // namespace trunk
