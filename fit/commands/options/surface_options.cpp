#include "commands/options/surface_options.hpp"

#include <fmt/format.h>

#include "commands/commands.hpp"
#include "commands/text/output.hpp"
#include "results/read/read_records.hpp"

namespace trunk {

void add_surface_options(CLI::App& command, SurfaceOptions& options) {
  constexpr const char* group = "How to read surfaces";
  command
      .add_option("--surface-unit", options.unit,
                  "Takes coordinates in this unit. [guessed from the size of the surface]")
      ->type_name("UNIT")
      ->group(group)
      ->check(one_of({"mm", "cm", "m"}));
  command
      .add_option("--axes", options.axes,
                  "Says to which sides x, y and z grow, as in LPS or RSA, or which coordinates point right, "
                  "forward and up, as in x,-z,y. [guessed]")
      ->type_name("AXES")
      ->group(group);
  command
      .add_option("--component", options.component,
                  "Takes only this component, group or solid of the file. [all]")
      ->type_name("NAME")
      ->group(group);
}

CLI::Option* add_surface_request(CLI::App& command, SurfaceRequest& request) {
  constexpr const char* group = "What to compare";
  auto* surface =
      command
          .add_option("--surface", request.surface,
                      "Compares with this measured surface (STL, OBJ, PLY, VTK, VTP, VTU or PML).")
          ->type_name("FILE")
          ->group(group);
  command
      .add_option(
          "--at", request.at,
          "Compares at this moment: start, peak (the largest lung volume), end, or a time in s. [peak]")
      ->type_name("MOMENT")
      ->group(group);
  command
      .add_option("--region", request.region,
                  "Compares this region: diaphragm, lung, abdomen, skin, or a region of the run such as "
                  "central_tendon. [diaphragm]")
      ->type_name("NAME")
      ->group(group);
  command
      .add_flag("--align", request.align,
                "First moves the surface onto the region, without changing its shape.")
      ->group(group);
  add_surface_options(command, request.options);
  return surface;
}

SurfaceAnswer compared(const SurfaceRequest& request, const std::string& run_file) {
  SurfaceAnswer answer{read_surface(request.surface, request.options), {}};
  const RunRecord run = read_run(run_file);
  ComparedSurface& beside = answer.beside;
  beside.surface = std::move(answer.file.surface);
  if (answer.file.axes_guessed || answer.file.axes_assumed)  // the doubt stands on the report page, too
    beside.surface.name +=
        fmt::format(" (axes {} as {})", answer.file.axes_guessed ? "guessed" : "assumed", answer.file.axes);
  beside.region =
      region_at(request.region, moment_of(request.at, run.trajectory, run_file), run.trajectory, run_file);
  for (const std::string& note : answer.file.notes) print_note("note: " + request.surface + ": " + note);
  beside.comparison = compare_shape(beside.region, beside.surface, request.align);
  return answer;
}

}  // namespace trunk
