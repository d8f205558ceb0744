#include "support/catch.hpp"
#include "support/traces.hpp"
#include "tables/clock_time.hpp"
#include "tables/column_names.hpp"
#include "traces/read_trace.hpp"

using namespace trunk;
using namespace trunk::test;

namespace {

/// `count` rows of a time, written by `time` from the number of the row, and a value 5 i with decimal comma.
template <class Time>
std::string german_rows(int count, Time time) {
  std::string text;
  for (int i = 0; i < count; ++i) text += time(i) + ";" + std::to_string(5 * i) + ",0\n";
  return text;
}

std::string padded(int number, std::size_t digits) {
  const std::string text = std::to_string(number);
  return std::string(digits - std::min(digits, text.size()), '0') + text;
}

std::string hundredths(int i) {
  return std::to_string(i / 100) + "," + padded(i % 100, 2);
}

}  // namespace

TEST_CASE("Columns are recognised by synonyms in several languages, and a note says so") {
  struct Case {
    std::string header;
    SignalKind kind;
    double unit;
  };
  const Case cases[] = {{"Zeit [s];Fluss (l/min)", SignalKind::flow, 1e-3 / 60},
                        {"Temps (s);D\xC3\xA9"
                         "bit (L/s)",
                         SignalKind::flow, 1e-3},
                        {"TEMPS (S);D\xC3\x89"
                         "BIT (L/S)",
                         SignalKind::flow, 1e-3},
                        {"Tiempo [s];Volumen [mL]", SignalKind::volume, 1e-6},
                        {"seconds;Resp flow ch2 (mL/sec)", SignalKind::flow, 1e-6},
                        {"t_s;Airflow [L/s]", SignalKind::flow, 1e-3},
                        {"Zeit [s];Lungenvolumen [cm\xC2\xB3]", SignalKind::volume, 1e-6},
                        {"Zeit [s];Volumen (l BTPS)", SignalKind::volume, 1e-3},
                        {"Zeit (s) seit Start;Flow (L/s) raw", SignalKind::flow, 1e-3}};
  for (const Case& c : cases) {
    CAPTURE(c.header);
    if (c.header.find("seit") != std::string::npos) {  // 'seit' may be anything
      CHECK_THAT(trace_error(c.header + "\n" + german_rows(12, hundredths)), Contains("no time column"));
      continue;
    }
    const Trace trace = trace_of(c.header + "\n" + german_rows(12, hundredths));
    CHECK(trace.kind == c.kind);
    REQUIRE(trace.time_s.size() == 12);
    CHECK(trace.time_s[11] == Approx(0.11));
    CHECK(trace.value[11] == Approx(55 * c.unit));
    REQUIRE(trace.notes.size() == 1);
    CHECK_THAT(trace.notes[0], Contains("taken by name: column '"));
  }
}

TEST_CASE("A column that may be another quantity is not taken by its name") {
  for (const std::string name :
       {"Peak flow [L/min]", "Minute volume [L]", "respiratory rate [1/min]", "flow_set_L_min"}) {
    CAPTURE(name);
    CHECK_FALSE(role_of(column_name(name)).has_value());
    CHECK_THAT(trace_error("Zeit [s];" + name + "\n" + german_rows(12, hundredths)),
               Contains("no volume or flow column"));
  }
  CHECK_THAT(trace_error("Zeit [s];Fluss 1 [L/s];Fluss 2 [L/s]\n" +
                         german_rows(12, [](int i) { return hundredths(i) + ";1"; })),
             Contains("two columns") && Contains("--flow"));
}

TEST_CASE("A belt is recognised by its name and keeps its own unit") {
  const Trace belt = trace_of("time_s;belt_au;SpO2\n" + german_rows(12, hundredths));
  CHECK(belt.kind == SignalKind::belt);
  CHECK(belt.value[11] == 55);
  REQUIRE(belt.notes.size() == 1);
  CHECK_THAT(belt.notes[0], Contains("'belt_au' as the belt"));

  TraceOptions declared;
  declared.value_column = "Kanal A [mV]";
  declared.kind = SignalKind::belt;
  const Trace strap = trace_of("time_s;Kanal A [mV]\n" + german_rows(12, hundredths), declared);
  CHECK(strap.kind == SignalKind::belt);
  CHECK(strap.value[11] == 55);
  CHECK(strap.notes.empty());
}

TEST_CASE("Lines above the header and a row of units below it are accepted") {
  const std::string rows = german_rows(12, hundredths);
  const std::string preamble =
      "Patient: M\xFCller\nGer\xE4t;Logger 3\nAbtastrate;100\nStart;12:00:01\n\n";  // Windows-1252
  const Trace trace = trace_of(preamble + "Zeit;Fluss;Druck\ns;L/s;mbar\n" + rows);
  CHECK(trace.time_s[11] == Approx(0.11));
  CHECK(trace.value[11] == Approx(55e-3));
  REQUIRE(trace.notes.size() == 1);

  const Trace brackets = trace_of("Zeit;Flu\xDF\n[s];[L/s]\n" + rows);
  CHECK(brackets.value[11] == Approx(55e-3));
  CHECK_THAT(brackets.notes[0], Contains("'Flu\xC3\x9F'"));

  const Trace titles = trace_of(
      "Interval=\t0.01 s\nTitle=\tTime\tFlow\nUnit=\ts\tL/s\nRange=\t1 V\t10 V\n" + trace_rows("\t", "\t1\n"),
      [] {
        TraceOptions options;
        options.time_column = "1";
        options.value_column = "2";
        options.time_unit = "s";
        options.kind = SignalKind::volume;
        options.unit = "ml";
        return options;
      }());
  CHECK(titles.value[11] == Approx(55e-6));

  // A bad first row is still a row.
  const Trace bad = trace_of("time_s,volume_ml\n0.00,cough\n0.01,5\n" + trace_rows().substr(14));
  CHECK(bad.time_s.size() == 11);
  REQUIRE(bad.notes.size() == 1);
  CHECK_THAT(bad.notes[0], Contains(":2: 'cough'"));
}

TEST_CASE("A table may have no header, or one in a comment") {
  TraceOptions options;
  options.time_column = "1";
  options.value_column = "2";
  options.unit = "L/s";
  const Trace trace = trace_of(trace_rows(), options);
  CHECK(trace.kind == SignalKind::flow);
  CHECK(trace.value[11] == Approx(55e-3));
  REQUIRE(trace.notes.size() == 1);
  CHECK_THAT(trace.notes[0], Contains("seconds are assumed"));
  options.time_unit = "ms";
  CHECK(trace_of(trace_rows(), options).time_s[11] == Approx(0.11e-3));
  options.value_column = "3";
  CHECK_THAT(trace_error(trace_rows(), options), Contains("FILE:1: no column '3' among '1', '2'"));

  CHECK(trace_of("# time_s volume_ml\n" + trace_rows(" ")).value[11] == Approx(55e-6));
}

TEST_CASE("A rate replaces the times, and unit options replace the units of the header") {
  TraceOptions options;
  options.rate_hz = 50;
  std::string values = "Flow\n";
  for (int i = 0; i < 12; ++i) values += std::to_string(i) + "\n";
  CHECK_THAT(trace_error(values, options), Contains("'Flow' has no unit") && Contains("--unit L/s"));
  options.unit = "L/min";
  const Trace trace = trace_of(values, options);
  CHECK(trace.time_s[11] == Approx(0.22));
  CHECK(trace.value[11] == Approx(11e-3 / 60));
  CHECK(trace.value_unit == "L_min");

  const Trace unused = trace_of("time_s,volume_ml\n" + trace_rows(), [] {
    TraceOptions both;
    both.rate_hz = 50;
    both.unit = "L";
    return both;
  }());
  CHECK(unused.time_s[11] == Approx(0.22));
  CHECK(unused.value[11] == Approx(55e-3));
  REQUIRE(unused.notes.size() == 2);
  CHECK_THAT(unused.notes[0], Contains("'time_s' is not used"));
  CHECK_THAT(unused.notes[1], Contains("is read in L, as --unit says, not in ml"));

  options.unit = "furlong";
  CHECK_THROWS_WITH(trace_of(values, options),
                    Contains("--unit furlong: ") && Contains("; expected a unit such as"));
  CHECK_THAT(trace_error("volume_ml\n1\n2\n"), Contains("--rate HZ"));
}

TEST_CASE("Clock times are counted from the first one, across midnight and the full hour") {
  CHECK(clock_time("14:05:07,25")->seconds == Approx(14 * 3600 + 5 * 60 + 7.25));
  CHECK(clock_time("2024-03-31T14:05:07.5Z")->seconds == Approx(1711893907.5));
  CHECK(clock_time("31.03.2024 14:05:07,5")->seconds == Approx(1711893907.5));
  CHECK(clock_time("2024-03-31 14:05:07+02:00")->seconds == Approx(1711893907.0 - 7200));
  for (const char* other : {"", "12", "12.5", ":", "1:", "12:61", "1:2:3:4", "24:00:00x",
                            "2024-02-30 10:00:00", "2024-03-31", "-1:00", "99999:00", "12:00:00.", "10:00 xm",
                            "1:2:3:4567", "1:2:3.5:400", "10:00+1:", "10:00 +99:00"})
    CHECK_FALSE(clock_time(other).has_value());

  const auto midnight = [](int i) {
    const int t = i + 23 * 360000 + 59 * 6000 + 5995;
    return padded(t / 360000 % 24, 2) + ":" + padded(t / 6000 % 60, 2) + ":" + padded(t / 100 % 60, 2) + "," +
           padded(t % 100, 2);
  };
  const Trace night = trace_of("Uhrzeit;Fluss [L/s]\n" + german_rows(12, midnight));
  CHECK(night.time_s.front() == 0);
  CHECK(night.time_s.back() == Approx(0.11));

  const auto hour = [](int i) {
    const int t = i + 59 * 6000 + 5995;
    return padded(t / 6000 % 60, 2) + ":" + padded(t / 100 % 60, 2) + "," + padded(t % 100, 2);
  };
  CHECK(trace_of("Zeit;Fluss [L/s]\n" + german_rows(12, hour)).time_s.back() == Approx(0.11));
}

TEST_CASE("Times of a coarse clock are spread evenly, and other shared times are errors") {
  const auto coarse = [](int i) { return hundredths(i / 5); };
  const Trace trace = trace_of("time_s;volume_ml\n" + german_rows(200, coarse));
  for (std::size_t i = 1; i < trace.time_s.size(); ++i)
    REQUIRE(trace.time_s[i] - trace.time_s[i - 1] == Approx(0.002));
  REQUIRE(trace.notes.size() == 1);
  CHECK_THAT(trace.notes[0], Contains("160 samples share") && Contains("500 a second"));

  const auto uneven = [](int i) { return hundredths(i < 100 ? i / 5 : i - 80); };
  CHECK_THAT(trace_error("time_s;volume_ml\n" + german_rows(200, uneven)),
             Contains("FILE:3: time 0 found after 0") && Contains("(and 79 more: `trunk check` lists all)"));
}

TEST_CASE("Isolated samples without a number are interpolated, and a note names the first") {
  const auto rows = [](int first, int count) {
    std::string text = "time_s,volume_ml\n";
    for (int i = 0; i < 300; ++i)
      text += hundredths(i).replace(hundredths(i).find(','), 1, ".") + "," +
              (i >= first && i < first + count ? "OVF" : std::to_string(i)) + "\n";
    return text;
  };
  const Trace trace = trace_of(rows(100, 25));
  REQUIRE(trace.value.size() == 300);
  for (std::size_t i = 0; i < 300; ++i) CHECK(trace.value[i] == Approx(1e-6 * static_cast<double>(i)));
  REQUIRE(trace.notes.size() == 1);
  CHECK_THAT(trace.notes[0], Contains("25 samples without a number interpolated; the first: ") &&
                                 Contains(":102: 'OVF' found in column 'volume_ml'"));
  CHECK_THAT(trace_error(rows(100, 26)),
             Contains("FILE:102: 'OVF'") && Contains("the first of 26 samples in a row"));
  CHECK(trace_of(rows(0, 25)).value.size() == 275);
  CHECK(trace_of(rows(280, 20)).value.size() == 280);
  CHECK_THAT(trace_error(rows(0, 26)), Contains("FILE:2: 'OVF'"));

  std::string often = "time_s,volume_ml\n";
  for (int i = 0; i < 100; ++i) often += "0." + padded(i, 2) + (i % 9 == 8 ? ",\n" : ",1\n");
  CHECK_THAT(trace_error(often),
             Contains("FILE:10: ") && Contains("the first of 11 samples, more than a tenth"));

  // Both at once, as `trunk check` lists them.
  std::string both = rows(100, 26);
  both += "1.0,1\n";
  CHECK_THAT(trace_error(both), Contains("FILE:102: ") && Contains("(and 1 more"));
}

TEST_CASE("Unusual sampling rates give a note, and rates below 4 a second are refused") {
  const auto at = [](double step_ms) {
    std::string text = "time_ms,volume_ml\n";
    for (int i = 0; i < 20; ++i) text += std::to_string(step_ms * i) + ",1\n";
    return text;
  };
  CHECK(trace_of(at(100)).notes.empty());
  CHECK(trace_of(at(0.5)).notes.empty());
  CHECK_THAT(trace_of(at(125)).notes.at(0), Contains("only 8 samples a second"));
  CHECK_THAT(trace_of(at(0.25)).notes.at(0), Contains("4000 samples a second"));
  CHECK(trace_error(at(250)).empty());
  CHECK_THAT(trace_error(at(260)),
             Contains("FILE: a sample every 0.26 s found; expected at least 4 a second"));
  TraceOptions seconds;
  seconds.time_unit = "s";
  CHECK_THAT(trace_error(at(10), seconds), Contains("may hold milliseconds") && Contains("--time-unit ms"));
}
