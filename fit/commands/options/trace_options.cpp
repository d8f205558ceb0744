#include "commands/options/trace_options.hpp"

#include "commands/commands.hpp"

namespace trunk {

void add_signal_options(CLI::App& command, SignalOptions& options) {
  auto* time =
      command.add_option("--time", options.time, "column of the times: name, or number from 1 [time_s]");
  CLI::Option* signals[] = {
      command.add_option("--flow", options.flow,
                         "column of the flow, positive on inspiration: name or number"),
      command.add_option("--volume", options.volume, "column of the volume: name or number"),
      command.add_option("--belt", options.belt, "column of a chest belt, in any unit: name or number"),
      command.add_option("--signal", options.signal, "column of a flow or volume, whichever its unit says")};
  for (CLI::Option* one : signals)
    for (CLI::Option* other : signals)
      if (one < other) one->excludes(other);
  command.add_option("--unit", options.unit,
                     "unit of the signal, where its header names none: L/s, L/min, ml, L");
  command.add_option("--time-unit", options.time_unit,
                     "unit of the times, where their header names none: s, ms, min");
  command.add_option("--rate", options.rate_hz, "samples a second, where the file has no times")
      ->check(within(1e-3, 1e6))
      ->excludes(time);
  command.add_flag("--invert", options.invert, "the signal is positive on expiration: turn its sign");
}

}  // namespace trunk
