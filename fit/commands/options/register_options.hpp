#pragma once

#include <CLI/CLI.hpp>
#include <optional>

#include "surfaces/read_surface.hpp"

namespace trunk {

/// What `register` is asked for, as typed.
struct RegisterRequest {
  std::string scenario, output, surface, skin, ribs;
  std::vector<std::string> lungs, landmarks;
  SurfaceOptions file;
  std::string lower_border = "auto", lung_side;
  std::optional<double> lung_volume_ml, apposition_length_mm;
  std::optional<int> resolution;
  double tolerance_mm = 5.0;
};

/// Adds the arguments and options of `register`, but not --json and --force.
void add_register_options(CLI::App& command, RegisterRequest& request);

}  // namespace trunk
