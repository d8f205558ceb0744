#include "commands/trace_options.hpp"

namespace trunk {

void add_signal_options(CLI::App& command, SignalOptions& options) {
  command.add_option("--time", options.columns.time_column, "name of the time column, if it is not time_s");
  command.add_option("--signal", options.columns.value_column,
                     "name of the flow or volume column; its unit must end the name");
  command.add_flag("--invert", options.invert, "the signal is positive on expiration: turn its sign");
}

Trace read_signal(const std::string& path, const SignalOptions& options) {
  Trace trace = read_trace(path, options.columns);
  if (options.invert)
    for (double& value : trace.value) value = -value;
  return trace;
}

}  // namespace trunk
