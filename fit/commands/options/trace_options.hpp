#pragma once

#include <CLI/CLI.hpp>

#include "traces/read_trace.hpp"

namespace trunk {

/// How to read the user's signal: which columns, in which units, which sign.
struct SignalOptions {
  std::string time, signal, flow, volume, belt;  ///< as given; of the last four at most one
  std::string unit, time_unit;
  double rate_hz = 0;
  bool invert = false;
};

/// --time, --flow, --volume, --belt, --signal, --unit, --time-unit, --rate and --invert.
void add_signal_options(CLI::App& command, SignalOptions& options);

/// Reads a trace and turns its sign where asked.
Trace read_signal(const std::string& path, const SignalOptions& options);

}  // namespace trunk
