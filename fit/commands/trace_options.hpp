#pragma once

#include <CLI/CLI.hpp>

#include "io/trace.hpp"

namespace trunk {

/// --time and --signal: which columns of a trace to read.
void add_trace_options(CLI::App& command, TraceOptions& options);

}  // namespace trunk
