#pragma once

#include <CLI/CLI.hpp>

#include "shape/compare_shape.hpp"
#include "surfaces/read_surface.hpp"

namespace trunk {

/// Adds --surface-unit, --axes and --component, which are the same in every command that reads a surface.
void add_surface_options(CLI::App& command, SurfaceOptions& options);

/// A measured surface, and the region of a run that is compared with it.
struct SurfaceRequest {
  std::string surface, at = "peak", region = "diaphragm";
  SurfaceOptions options;
  bool align = false;
};

/// Adds --surface, --at, --region, --align and the options above. Returns --surface.
CLI::Option* add_surface_request(CLI::App& command, SurfaceRequest& request);

struct SurfaceAnswer {
  ImportedSurface file;  ///< without its surface, which is in `beside`
  ComparedSurface beside;
};

/// Reads the surface, prints the notes about it, and compares. Throws InputError.
SurfaceAnswer compared(const SurfaceRequest& request, const std::string& run_file);

}  // namespace trunk
