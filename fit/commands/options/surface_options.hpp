#pragma once

#include <CLI/CLI.hpp>

#include "shape/compare_shape.hpp"
#include "surfaces/read_surface.hpp"

namespace trunk {

/// --surface-unit, --axes and --component, the same wherever a command reads a surface.
void add_surface_options(CLI::App& command, SurfaceOptions& options);

/// A measured surface to hold a region of a run against.
struct SurfaceRequest {
  std::string surface, at = "peak", region = "diaphragm";
  SurfaceOptions options;
  bool align = false;
};

/// --surface, which is returned, --at, --region, --align and the options above.
CLI::Option* add_surface_request(CLI::App& command, SurfaceRequest& request);

struct SurfaceAnswer {
  ImportedSurface file;  // without its surface, which is in `beside`
  ComparedSurface beside;
};

/// Reads the surface, says its notes, and compares. Throws InputError.
SurfaceAnswer compared(const SurfaceRequest& request, const std::string& run_file);

}  // namespace trunk
