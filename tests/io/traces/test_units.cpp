#include <cmath>

#include "support/catch.hpp"
#include "support/edf_file.hpp"
#include "support/temporary_folder.hpp"
#include "support/traces.hpp"
#include "tables/column_names.hpp"

using namespace trunk;
using namespace trunk::test;

namespace {

constexpr double litre = 1e-3, ml = 1e-6, minute = 60, hour = 3600;

bool told(const Trace& trace, const std::string& part) {
  return std::any_of(trace.notes.begin(), trace.notes.end(),
                     [&](const std::string& note) { return note.find(part) != std::string::npos; });
}

}  // namespace

TEST_CASE("A factor before a unit is applied", "[faults]") {
  struct Case {
    const char* header;
    SignalKind kind;
    double unit;
  };
  using enum SignalKind;
  const auto [header, kind, unit] =
      GENERATE(values<Case>({{"Flow (0.1 L/min)", flow, 0.1 * litre / minute},
                             {"\"Flow (0,1 l/min)\"", flow, 0.1 * litre / minute},
                             {"Flow [10 mL/s]", flow, 10 * ml},
                             {"Flow (1/100 L/s)", flow, 0.01 * litre},
                             {"Flow (1e-3 L/s)", flow, 1e-3 * litre},
                             {"Flow (10^-3 L/s)", flow, 1e-3 * litre},
                             {"Flow (10⁻³ L·s⁻¹)", flow, 1e-3 * litre},
                             {"Flow (10*mL/s)", flow, 10 * ml},
                             {"Flow (100 mL/min BTPS)", flow, 100 * ml / minute},
                             {"Flow (1 L/s)", flow, litre},
                             {"Volume (0.1 ml)", volume, 0.1 * ml},
                             {"Volume (10 ml) filtered", volume, 10 * ml}}));
  CAPTURE(header);
  const Trace trace = trace_of("time_s," + std::string(header) + "\n" + trace_rows());
  CHECK(trace.kind == kind);
  CHECK(trace.value[11] == Approx(55 * unit));
  CHECK(told(trace, "as its unit says") == (header != std::string("Flow (1 L/s)")));
  const Trace row = trace_of("time_s,Flow\ns,0.1 l/min\n" + trace_rows());
  CHECK(row.value[11] == Approx(5.5 * litre / minute));
  CHECK(trace_of("Time (0.01 s),volume_ml\n" + trace_rows()).time_s[11] == Approx(0.0011));
}

TEST_CASE("A volume over a time is a flow in any of their units", "[faults]") {
  struct Case {
    const char* header;
    double unit;
  };
  const auto [header, unit] = GENERATE(values<Case>({{"Flow (dL/s)", 0.1 * litre},
                                                     {"flow_dL_s", 0.1 * litre},
                                                     {"Flow (L/h)", litre / hour},
                                                     {"Flow [cL/min]", 0.01 * litre / minute},
                                                     {"Flow (m³/h)", 1 / hour},
                                                     {"Flow (litres per minute)", litre / minute},
                                                     {"Flow (mouth, L/s)", litre},
                                                     {"Flow (L s-1)", litre},
                                                     {"Flow (ml·min^-1)", ml / minute}}));
  CAPTURE(header);
  const Trace trace = trace_of("time_s;" + std::string(header) + "\n" + trace_rows(";"));
  CHECK(trace.kind == SignalKind::flow);
  CHECK(trace.value[11] == Approx(55 * unit));
}

TEST_CASE("A unit that is not known, or may mean two, is refused by name", "[faults]") {
  const std::string unit =
      GENERATE("ml/s x10", "ml/s*10", "x10 ml/s", "10e-3 L/s", "1.000 ml/s", "5 ml/s", "gal/min",
               "tenths of L/s", "milli L/s", "%", "psi", "L/s^2", "ml/kg", "/min", "0.1", "x10", "100");
  CAPTURE(unit);
  const std::string text = "time_s;Flow (" + unit + ")\n" + trace_rows(";");
  for (const std::string& error : {trace_error(text), trace_error(text, [] {
                                     TraceOptions chosen;
                                     chosen.value_column = "2", chosen.kind = SignalKind::flow;
                                     return chosen;
                                   }())}) {
    CHECK_THAT(error, Contains("the unit '" + unit + "' of") && Contains("is not known or not clear") &&
                          Contains("with a factor before it as in (0.1 L/s)"));
    CHECK_THAT(error, !Contains("may hold"));
  }
  TraceOptions given;
  given.value_column = "2", given.unit = "0.1 L/min";  // the user knows
  CHECK(trace_of(text, given).value[11] == Approx(5.5 * litre / minute));
}

TEST_CASE("A number outside of brackets may be a factor or the number of a channel", "[faults]") {
  for (const std::string header : {"Flow 10 mL/s", "Flow 0.1 L/min", "flow_x10_ml_s", "Flow 100 (L/s)",
                                   "0.1*Flow (L/s)", "Flow ×10 (L/s)", "10 x Flow (L/s)", "0.1 Flow (L/s)",
                                   "Flow in tenths of L/s", "Flow (L/s) * 1000", "Flow deci L/s"}) {
    CAPTURE(header);
    TraceOptions chosen;
    chosen.value_column = "2", chosen.kind = SignalKind::flow;
    CHECK_THAT(trace_error("time_s," + header + "\n" + trace_rows(), chosen),
               Contains("the unit '" + header + "' of the chosen column"));
    CHECK_FALSE(trace_error("time_s," + header + "\n" + trace_rows()).empty());
  }
  for (const std::string header : {"Flow 2 (L/s)", "flow_1_L_s", "Flow ch12 [L/s]", "Flow* (L/s)"})
    CHECK(trace_of("time_s," + header + "\n" + trace_rows()).value[11] == Approx(55 * litre));
}

TEST_CASE("The unit that an EDF file gives has a factor too, or is refused", "[faults]") {
  const TemporaryFolder folder;
  const auto file = [&](const std::string& unit) {
    const auto wave = [](int i) { return std::sin(0.03 * i); };
    return folder.write("t.edf", edf_bytes({{"Flow", unit, 50, 2, wave}}, 20));
  };
  CHECK(read_trace(file("10 mL/s")).value[50] == Approx(10 * ml * std::sin(1.5)).margin(1e-9));
  for (const std::string unit : {"x10 mL/s", "0.1 L/mi", "V"})  // 8 characters are all that EDF has
    CHECK_THAT(trace_error_at(file(unit)),
               Contains("the unit '" + unit + "' of 'Flow' is not known or not clear"));
}

TEST_CASE("Two units of one column contradict each other", "[faults]") {
  CHECK_THAT(trace_error("Zeit,Flow (L/min)\ns,L/s\n" + trace_rows()),
             Contains("the unit 'L_min and L_s' of the chosen column 'Flow (L/min)'"));
  CHECK_THAT(trace_error("Zeit,flow_L_s\ns,V/s\n" + trace_rows()),
             Contains("the unit 'V/s' of the chosen column"));
  CHECK(trace_of("Zeit,flow_L_s\ns,n/a\n" + trace_rows()).value[11] == Approx(55 * litre));
  CHECK(trace_of("Zeit,Flow (L/s)\ns,l/sec\n" + trace_rows()).value[11] == Approx(55 * litre));
}

TEST_CASE("Options take factors, and refuse what may mean two", "[faults]") {
  TraceOptions options;
  options.unit = "10 ml/s";
  CHECK(trace_of("time_s,Flow\n" + trace_rows(), options).value[11] == Approx(550 * ml));
  options.unit = "ml/s*10";
  CHECK_THROWS_WITH(
      trace_of("time_s,Flow\n" + trace_rows(), options),
      Contains("--unit ml/s*10: this is not a known unit") && Contains("factor before the unit"));
  TraceOptions time;
  time.time_unit = "10 ms";
  CHECK(trace_of("t,volume_ml\n" + trace_rows(), time).time_s[11] == Approx(0.11 * 0.01));
}

TEST_CASE("Pressures take factors, and units that are not known or differ are told", "[faults]") {
  const auto with_pes = [](const std::string& header, const std::string& unit = "") {
    TraceOptions options;
    options.channels.poes = "3", options.channels.pressure_unit = unit;
    std::string text = "time_s;volume_ml;" + header + "\n";
    for (int i = 0; i < 12; ++i)
      text += std::to_string(0.01 * i) + ";" + std::to_string(i) + ";" + std::to_string(i) + "\n";
    return std::pair(text, options);
  };
  const auto [tenth, options] = with_pes("Pes (0.1 kPa)");
  CHECK(trace_of(tenth, options).channels.at(0).value[11] == Approx(1100));
  CHECK(told(trace_of(tenth, options), "'Pes (0.1 kPa)' is 0.1 kPa, as its unit says"));
  for (const std::string unit : {"mmH2O", "kPa*10", "psi", "V", "bar", "daPa"}) {
    CAPTURE(unit);
    const auto [text, chosen] = with_pes("Pes (" + unit + ")");
    CHECK_THAT(trace_error(text, chosen), Contains("the unit '" + unit + "' of the chosen column"));
    const auto [same, known] = with_pes("Pes (" + unit + ")", "0.1 kPa");
    CHECK(trace_of(same, known).channels.at(0).value[11] == Approx(1100));
  }
  for (const std::string word : {"filtered", "left", "a.u.", "ch2"}) {
    const auto [text, chosen] = with_pes("Pes (" + word + ")");
    CHECK(told(trace_of(text, chosen), "cmH2O is assumed"));
  }
  std::string two = "time_s;volume_ml;Pes (kPa);Pga (cmH2O)\n";
  for (int i = 0; i < 12; ++i) two += std::to_string(0.01 * i) + ";1;2;3\n";
  CHECK(told(trace_of(two),
             "the pressures are in different units, column 'Pes (kPa)' in kPa, column 'Pga (cmH2O)'"));
}

TEST_CASE("A second header in the middle of a table is refused unless it is the first one again",
          "[faults]") {
  const std::string rows = trace_rows();
  const auto both = [&](const std::string& header, const std::string& second) {
    return trace_error(header + "\n" + rows + second + "\n" + "0.12,1\n0.13,2\n0.14,3\n");
  };
  CHECK_THAT(both("time_s,flow_L_s", "time_s,flow_L_min"), Contains("FILE:14: a second header, 'time_s'"));
  CHECK_THAT(both("time,flow\ns,L/s", "s,L/min"), Contains("FILE:15: a second header, 's'"));
  CHECK_THAT(both("time_s,flow_L_s", "time_ms,flow_L_s"), Contains("names and units hold to its end"));
  CHECK(both("time_s,flow_L_s", "time_s,flow_L_s").empty());
  CHECK(both("time_s,flow_L_s", "cough,n/a").empty());
}

TEST_CASE("A sampling rate that changes is told, and one that jitters is not", "[faults]") {
  const auto table = [](auto step) {
    std::string text = "time_s,volume_ml\n";
    double t = 0;
    for (int i = 0; i < 2000; t += step(i), ++i)
      text += std::to_string(t) + "," + std::to_string(i % 7) + "\n";
    return text;
  };
  const Trace halved = trace_of(table([](int i) { return i < 1000 ? 0.01 : 0.02; }));
  CHECK(told(halved, "the sampling rate changes near 9.99 s from 100 to 50 samples a second"));
  CHECK_FALSE(told(trace_of(table([](int i) { return i % 3 == 0 ? 0.016 : 0.008; })), "sampling rate"));
}
