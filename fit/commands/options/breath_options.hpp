#pragma once

#include <CLI/CLI.hpp>

#include "breaths/selection.hpp"

namespace trunk {

/// Adds --exclude, --include, --begin, --end and --calibrate-tidal-volume.
void add_breath_options(CLI::App& command, BreathSelection& selection);

}  // namespace trunk
