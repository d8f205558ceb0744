#pragma once

#include <CLI/CLI.hpp>

#include "traces/read_signal.hpp"

namespace trunk {

/// Adds --time, --flow, --volume, --belt, --signal, --unit, --time-unit, --rate and --invert.
void add_signal_options(CLI::App& command, SignalOptions& options);

}  // namespace trunk
