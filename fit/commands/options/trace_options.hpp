#pragma once

#include <CLI/CLI.hpp>

#include "clinic/clinic.hpp"
#include "traces/read_signal.hpp"

namespace trunk {

/// Adds --time, --flow, --volume, --belt, --signal, --unit, --time-unit, --rate, --invert, --encoding and
/// --block, and the options of channels beside the signal.
void add_signal_options(CLI::App& command, SignalOptions& options);

/// Adds --pdi-max and --chest-wall-compliance.
void add_clinic_options(CLI::App& command, ClinicOptions& options);

}  // namespace trunk
