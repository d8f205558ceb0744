#include "commands/options/trace_options.hpp"

#include "commands/commands.hpp"
#include "math/units.hpp"

namespace trunk {
namespace {

void add_channel_options(CLI::App& command, ChannelOptions& options) {
  constexpr const char* group = "Channels beside the signal";
  const auto channel = [&](const char* names, std::string& value, const char* type, const char* text) {
    command.add_option(names, value, text)->type_name(type)->group(group);
  };
  channel("--poes,--pes", options.poes, "COL",
          "Takes oesophageal pressure from this column. none leaves it out. [a column named poes or pes]");
  channel("--pga,--pgas", options.pga, "COL", "Takes gastric pressure from this column. [pga or pgas]");
  channel("--pdi", options.pdi, "COL", "Takes transdiaphragmatic pressure from this column. [pdi]");
  channel("--paw", options.paw, "COL", "Takes airway pressure from this column. [paw]");
  channel("--emg", options.emg, "COL",
          "Takes an EMG of the diaphragm, raw or as an envelope, from this column.");
  channel("--excursion", options.excursion, "COL|MM",
          "Gives how far a dome of the diaphragm descends with a breath: a number in mm, or a column.");
  channel("--pressure-unit", options.pressure_unit, "UNIT",
          "Gives the unit of all pressures: cmH2O, mbar, hPa, kPa, Pa or mmHg. [as in the header, or else "
          "cmH2O]");
  command
      .add_option("--invert-channel", options.inverted,
                  "Reverses the sign of a channel: poes, pga, pdi, paw, excursion or emg. You can repeat it.")
      ->type_name("NAME")
      ->group(group)
      ->take_all()
      ->allow_extra_args(false);
}

}  // namespace

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
      .add_option(
          "--unit", options.unit,
          "Gives the unit of the signal if the header has none or a wrong one: L/s, L/min, ml, L, or one "
          "with a factor such as '0.1 L/min'.")
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
  command
      .add_flag("--remove-drift", options.remove_drift,
                "Takes a drift as large as a breath for an offset of the sensor, and removes it. Without it, "
                "such a "
                "signal is refused, since it may be a counter or a flow without its sign.")
      ->group(group);
  command
      .add_option("--encoding", options.encoding,
                  "Gives the encoding of a text that is neither UTF-8, UTF-16 nor Windows-1252, as "
                  "Shift_JIS. `iconv -l` lists the names.")
      ->type_name("NAME")
      ->group(group);
  command
      .add_option(
          "--block", options.block,
          "Reads this block of a LabChart text, or this part of an interrupted EDF+ file, from 1. [the "
          "longest]")
      ->type_name("N")
      ->group(group)
      ->check(within(1, 1e6));
  add_channel_options(command, options.channels);
}

void add_clinic_options(CLI::App& command, ClinicOptions& options) {
  constexpr const char* group = "Numbers of a clinic";
  command
      .add_option_function<double>(
          "--pdi-max", [&options](double cmH2O) { options.pdi_max_Pa = Pa_per_cmH2O * cmH2O; },
          "Gives the transdiaphragmatic pressure of a maximal effort in cmH2O, for the tension-time index.")
      ->type_name("CMH2O")
      ->group(group)
      ->check(within(5.0, 500.0));
  command
      .add_option_function<double>(
          "--chest-wall-compliance",
          [&options](double ml) { options.chest_wall_compliance_m3_Pa = m3_per_ml * ml / Pa_per_cmH2O; },
          "Gives the compliance of the relaxed chest wall in ml/cmH2O. Without it, work and pressure-time "
          "product "
          "leave out what the chest wall takes.")
      ->type_name("ML")
      ->group(group)
      ->check(within(10.0, 2000.0));
}

}  // namespace trunk
