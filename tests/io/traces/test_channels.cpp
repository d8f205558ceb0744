#include <cmath>
#include <numbers>

#include "support/catch.hpp"
#include "support/edf_file.hpp"
#include "support/temporary_folder.hpp"
#include "support/traces.hpp"

using namespace trunk;
using namespace trunk::test;

namespace {

/// Twelve rows: time, volume and one more column from 1 to 12.
std::string table(const std::string& header, const std::string& cell_of_row_6 = "6") {
  std::string text = "time_s,volume_ml," + header + "\n";
  for (int i = 0; i < 12; ++i)
    text += std::to_string(0.01 * i) + "," + std::to_string(5 * i) + "," +
            (i == 5 ? cell_of_row_6 : std::to_string(i + 1)) + "\n";
  return text;
}

TraceOptions with(std::string ChannelOptions::*member, const std::string& value) {
  TraceOptions options;
  options.channels.*member = value;
  return options;
}

/// The error of an option, which names no file; "" when there was none.
std::string error_without_file(const std::string& text, const TraceOptions& options) {
  try {
    trace_of(text, options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

bool noted(const Trace& trace, const std::string& part) {
  return std::any_of(trace.notes.begin(), trace.notes.end(),
                     [&](const std::string& note) { return note.find(part) != std::string::npos; });
}

}  // namespace

TEST_CASE("A pressure is read in the unit of its header") {
  struct Case {
    const char* header;
    double Pa;
  };
  const auto [header, Pa] = GENERATE(values<Case>({{"Pes (cmH2O)", 98.0665},
                                                   {"Poes [kPa]", 1000},
                                                   {"P_oes (cm H2O)", 98.0665},
                                                   {"pes_hPa", 100},
                                                   {"PES [mbar]", 100},
                                                   {"poes_Pa", 1},
                                                   {"Pes (mmHg)", 133.322387415},
                                                   {"Pes (cmH₂O)", 98.0665}}));
  CAPTURE(header);
  const Trace trace = trace_of(table(header));
  REQUIRE(trace.channels.size() == 1);
  CHECK(trace.channels[0].kind == ChannelKind::pleural);
  CHECK(trace.channels[0].column == header);
  REQUIRE(trace.channels[0].value.size() == 12);
  CHECK(trace.channels[0].value[11] == Approx(12 * Pa));
  CHECK(noted(trace, "as the oesophageal pressure"));
  CHECK_FALSE(noted(trace, "assumed"));
}

TEST_CASE("Only names that nothing else has are taken without an option") {
  struct Case {
    const char* header;
    ChannelKind kind;
  };
  const auto [header, kind] = GENERATE(values<Case>({{"Pga", ChannelKind::gastric},
                                                     {"pgas", ChannelKind::gastric},
                                                     {"Pdi", ChannelKind::transdiaphragmatic},
                                                     {"Paw", ChannelKind::airway}}));
  const Trace trace = trace_of(table(header));
  REQUIRE(trace.channels.size() == 1);
  CHECK(trace.channels[0].kind == kind);
  CHECK(trace.channels[0].value[0] == Approx(98.0665));
  CHECK(noted(trace, "cmH2O is assumed (--pressure-unit"));
  for (const char* other : {"pressure_cmH2O", "p", "EMG1", "pes_max", "excursion_mm", "paws"})
    CHECK(trace_of(table(other)).channels.empty());
  std::string two = "time_s,volume_ml,pes,poes\n";
  for (int i = 0; i < 12; ++i) two += std::to_string(0.01 * i) + "," + std::to_string(i) + ",1,2\n";
  const Trace both = trace_of(two);
  CHECK(both.channels.empty());
  CHECK(noted(both,
              "'pes' and 'poes' may both be the oesophageal pressure: neither is used (--poes chooses one)"));
}

TEST_CASE("Options choose channels, their unit and their sign, or leave them out") {
  CHECK(trace_of(table("poes"), with(&ChannelOptions::poes, "none")).channels.empty());
  for (const char* name : {"balloon 1", "3"}) {
    const Trace trace = trace_of(table("balloon 1"), with(&ChannelOptions::poes, name));
    REQUIRE(trace.channels.size() == 1);
    CHECK_FALSE(noted(trace, "taken by name"));
  }
  TraceOptions options = with(&ChannelOptions::pga, "x");
  options.channels.pressure_unit = "kPa";
  options.channels.inverted = {"pga"};
  const Trace trace = trace_of(table("x (mbar)"), options);
  CHECK(trace.channels.at(0).kind == ChannelKind::gastric);
  CHECK(trace.channels[0].value[11] == Approx(-12e3));
  CHECK(noted(trace, "is read in kPa, as --pressure-unit says, not in mbar"));
  const Trace emg = trace_of(table("EMGdi (mV)"), with(&ChannelOptions::emg, "EMGdi (mV)"));
  CHECK(emg.channels.at(0).value[11] == 12);
  const Trace dome = trace_of(table("dome_cm"), with(&ChannelOptions::excursion, "dome"));
  CHECK(dome.channels.at(0).value[11] == Approx(0.12));
  const Trace number = trace_of(table("x"), with(&ChannelOptions::excursion, "14.5"));
  CHECK(number.channels.empty());
  CHECK(number.excursion_m.value() == Approx(0.0145));
}

TEST_CASE("A channel that cannot be what an option says is refused by name") {
  using C = ChannelOptions;
  CHECK_THAT(trace_error(table("x"), with(&C::poes, "y")), Contains("FILE:1: no column 'y'"));
  CHECK_THAT(trace_error(table("x"), with(&C::poes, "volume_ml")), Contains("names the breathing signal"));
  CHECK_THAT(trace_error(table("x"), with(&C::poes, "1")), Contains("names the times"));
  CHECK_THAT(trace_error(table("x_mm"), with(&C::poes, "x")),
             Contains("'x_mm' is in mm and not in a unit of pressure") && Contains("--pressure-unit cmH2O"));
  CHECK_THAT(trace_error(table("x_kPa"), with(&C::excursion, "x")), Contains("not in a unit of length"));
  const auto error_of = [](const TraceOptions& options) {
    return error_without_file(table("poes"), options);
  };
  CHECK_THAT(error_of(with(&C::pressure_unit, "bar")),
             Contains("--pressure-unit bar: this is not a known unit"));
  CHECK_THAT(error_of(with(&C::excursion, "400")), Contains("--excursion 400") && Contains("1 to 150 mm"));
  TraceOptions options;
  options.channels.inverted = {"flow"};
  CHECK_THAT(error_of(options), Contains("--invert-channel flow: this is no channel"));
}

TEST_CASE("Missing numbers of a channel are interpolated, or stay a gap of that channel alone") {
  const Trace trace = trace_of(table("poes", ""));
  CHECK(trace.channels.at(0).value[5] == Approx(6 * 98.0665));
  CHECK(noted(trace, "1 sample of column 'poes' without a number interpolated"));
  std::string text = "time_s,volume_ml,poes\n";
  for (int i = 0; i < 200; ++i)
    text += std::to_string(0.01 * i) + "," + std::to_string(i) + "," +
            (i >= 50 && i < 90 ? "" : std::to_string(i)) + "\n";
  const Trace gap = trace_of(text);
  CHECK(gap.time_s.size() == 200);
  CHECK(std::isnan(gap.channels.at(0).value[70]));
  CHECK(std::isfinite(gap.channels[0].value[90]));
  CHECK(noted(gap, "column 'poes' has 1 gap of up to 0.41 s, the first at 0.5 s"));
  std::string empty = "time_s,volume_ml,poes\n";
  for (int i = 0; i < 20; ++i) empty += std::to_string(0.01 * i) + "," + std::to_string(i) + ",n/a\n";
  CHECK_THAT(trace_error(empty),
             Contains("0 of 20 samples of column 'poes' have a number") && Contains("--poes none"));
}

TEST_CASE("A channel keeps its place in time if samples at the beginning are left out") {
  std::string text = "time_s,volume_ml,poes\n";
  for (int i = 0; i < 40; ++i)
    text +=
        std::to_string(0.01 * i) + "," + (i < 4 ? "" : std::to_string(i)) + "," + std::to_string(i) + "\n";
  const Trace trace = trace_of(text);
  REQUIRE(trace.time_s.size() == 36);
  CHECK(trace.time_s[0] == Approx(0.04));
  CHECK(trace.channels.at(0).value[0] == Approx(4 * 98.0665));
}

TEST_CASE("A channel of another rate is refused if an option names it, and left out otherwise") {
  const auto wave = [](int rate) {
    return [rate](int i) { return std::sin(2 * std::numbers::pi * i / (3.0 * rate)); };
  };
  const std::string bytes =
      edf_bytes({{"Flow", "L/s", 50, 2, wave(50)}, {"Pes", "cmH2O", 25, 2, wave(25)}}, 20);
  const TemporaryFolder folder;
  const auto path = folder.write("t.edf", bytes);
  const Trace trace = read_trace(path);
  CHECK(trace.channels.empty());
  CHECK(noted(trace, "channel 'Pes' has 25 samples a second, and channel 'Flow' has 50: it is not used"));
  CHECK_THAT(trace_error_at(path, with(&ChannelOptions::poes, "Pes")),
             Contains("'Pes' has 25 samples a second") && Contains("the same samples"));
  const auto same = folder.write(
      "s.edf", edf_bytes({{"Flow", "L/s", 50, 2, wave(50)}, {"Pes", "kPa", 50, 2, wave(50)}}, 20));
  CHECK(read_trace(same).channels.at(0).value[37] == Approx(1000 * wave(50)(37)).margin(0.1));
}

TEST_CASE("A volume beside a flow shows which way the flow goes") {
  const auto text = [](double sign, bool resets) {
    std::string rows = "time_s,flow_L_s,volume\n";
    for (int i = 0; i < 2000; ++i) {
      const double t = 0.01 * i, w = std::numbers::pi / 2, volume = 1 - std::cos(w * t);
      const double shown = resets && std::sin(w * t) < 0 ? volume - 2 : volume;  // starts anew at the top
      rows += std::to_string(t) + "," + std::to_string(sign * w * std::sin(w * t)) + "," +
              std::to_string(shown) + "\n";
    }
    return rows;
  };
  for (const bool resets : {false, true}) {
    CAPTURE(resets);
    const Trace upright = trace_of(text(1, resets)), turned = trace_of(text(-1, resets));
    CHECK(upright.sign == SignShownBy::volume);
    CHECK_FALSE(noted(upright, "turned"));
    CHECK(turned.sign == SignShownBy::volume);
    CHECK(noted(turned,
                "flow 'flow_L_s' is negative on inspiration and is turned: it runs against volume 'volume'"));
    CHECK(turned.value == upright.value);
  }
  TraceOptions invert;
  invert.invert = true;
  const Trace agreed = trace_of(text(-1, false), invert), against = trace_of(text(1, false), invert);
  CHECK(agreed.sign == SignShownBy::volume);
  CHECK_FALSE(noted(agreed, "turns"));
  CHECK(against.sign == SignShownBy::shape);
  CHECK(noted(against, "--invert turns flow 'flow_L_s' against volume 'volume'"));
}
