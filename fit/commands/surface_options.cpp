#include "commands/surface_options.hpp"

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

}  // namespace trunk
