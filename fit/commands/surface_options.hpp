#pragma once

#include <CLI/CLI.hpp>

#include "io/surface_file.hpp"

namespace trunk {

/// --surface-unit, --axes and --component, the same wherever a command reads a surface.
void add_surface_options(CLI::App& command, SurfaceOptions& options);

}  // namespace trunk
