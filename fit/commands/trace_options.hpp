#pragma once

#include <CLI/CLI.hpp>

#include "io/trace.hpp"

namespace trunk {

/// How to read the user's signal: which columns, which sign.
struct SignalOptions {
  TraceOptions columns;
  bool invert = false;
};

/// --time, --signal and --invert.
void add_signal_options(CLI::App& command, SignalOptions& options);

/// Reads a trace and turns its sign where asked.
Trace read_signal(const std::string& path, const SignalOptions& options);

}  // namespace trunk
