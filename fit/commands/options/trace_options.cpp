#include "commands/options/trace_options.hpp"

#include "commands/commands.hpp"

namespace trunk {

void add_signal_options(CLI::App& command, SignalOptions& options) {
  constexpr const char* group = "How to read the trace";
  const auto column = [&command](const char* name, std::string& value, const char* text) {
    return command.add_option(name, value, text)->type_name("COL")->group(group);
  };
  auto* time = column("--time", options.time,
                      "Takes the times from this column. Give its name or its number from 1. [time_s]");
  CLI::Option* signals[] = {
      column("--flow", options.flow, "Takes the flow, positive on inspiration, from this column."),
      column("--volume", options.volume, "Takes the volume from this column."),
      column("--belt", options.belt, "Takes the signal of a chest belt, in any unit, from this column."),
      column("--signal", options.signal,
             "Takes flow or volume from this column; its unit says which it is.")};
  for (CLI::Option* one : signals)
    for (CLI::Option* other : signals)
      if (one < other) one->excludes(other);
  command
      .add_option("--unit", options.unit,
                  "Gives the unit of the signal if the header has none: L/s, L/min, ml or L.")
      ->type_name("UNIT")
      ->group(group);
  command
      .add_option("--time-unit", options.time_unit,
                  "Gives the unit of the times if the header has none: s, ms or min.")
      ->type_name("UNIT")
      ->group(group);
  command
      .add_option("--rate", options.rate_hz,
                  "Gives the samples a second (Hz) if the file has no column of times.")
      ->type_name("HZ")
      ->group(group)
      ->check(within(1e-3, 1e6))
      ->excludes(time);
  command
      .add_flag("--invert", options.invert, "Reverses the sign of a signal that is positive on expiration.")
      ->group(group);
}

}  // namespace trunk
