#include <fmt/format.h>

#include <cmath>
#include <functional>

#include "support/catch.hpp"
#include "support/traces.hpp"

using namespace trunk;
using namespace trunk::test;

namespace {

constexpr int rows_written = 300;

double written_flow(int i) {
  return 0.5 * std::sin(0.03 * i);
}

/// A text of LabChart: its header lines, and rows of a time, a flow and a pressure.
struct LabChart {
  std::string delimiter = "\t", end = "\n", interval = "0.01 s", units = "UnitName=|L/s|cmH2O";
  std::function<std::string(int)> time = [](int i) { return fmt::format("{:.2f}", 0.01 * i); };
  std::function<std::string(int)> tail = [](int) { return ""; };
  int count = rows_written;

  std::string text() const {
    std::string all = "Interval=|" + interval + "\nExcelDateTime=|4.5363e+004|12/03/2024 09:42:10\n" +
                      "TimeFormat=|StartOfBlock\nDateFormat=|\nChannelTitle=|Flow|Pmouth\n" +
                      "Range=|10.000 V|20 cmH2O\n" + (units.empty() ? "" : units + "\n");
    for (int i = 0; i < count; ++i)
      all += (time ? time(i) + "|" : "") + fmt::format("{:.6f}|1.5", written_flow(i)) + tail(i) + "\n";
    std::string result;
    for (const char c : all) result += c == '|' ? delimiter : c == '\n' ? end : std::string(1, c);
    return result;
  }
};

void check_flow(const Trace& trace, int count = rows_written, double unit = 1e-3) {
  CHECK(trace.kind == SignalKind::flow);
  REQUIRE(trace.value.size() == static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    REQUIRE(trace.time_s[i] - trace.time_s[0] == Approx(0.01 * i).margin(1e-9));
    REQUIRE(trace.value[i] == Approx(unit * written_flow(i)).margin(1e-6 * unit));
  }
}

TraceOptions block(std::size_t number) {
  TraceOptions options;
  options.block = number;
  return options;
}

}  // namespace

TEST_CASE("A text of LabChart gives names, units and times", "[faults]") {
  LabChart file;
  SECTION("as LabChart writes it") {
    check_flow(trace_of(file.text()));
  }
  SECTION("with other delimiters and line ends") {
    file.delimiter = GENERATE("\t", ";", ",");
    file.end = GENERATE("\n", "\r\n", "\r");
    check_flow(trace_of(file.text()));
  }
  SECTION("without times, since the interval tells them in any unit") {
    file.time = nullptr;
    file.interval = GENERATE("0.01 s", "10 ms", "0,01 s", "1e-2 s", "0.01");
    check_flow(trace_of(file.text()));
    std::string joined = file.text();
    joined.erase(joined.find('\t'), 1);  // "Interval=0.01 s"
    check_flow(trace_of(joined));
  }
  SECTION("with times in the unit that agrees with the interval") {
    const double factor = GENERATE(1e3, 1 / 60.0);
    file.time = [factor](int i) { return fmt::format("{:.9g}", factor * 0.01 * i); };
    check_flow(trace_of(file.text()));
  }
  SECTION("with clock times and a date, in either order") {
    const bool date_first = GENERATE(true, false);
    file.time = [date_first](int i) {
      const std::string clock = fmt::format("9:42:{:05.2f}", 10 + 0.01 * i), date = "12/03/2024";
      return date_first ? date + "|" + clock : clock + "|" + date;
    };
    check_flow(trace_of(file.text()));
  }
  SECTION("with decimal commas") {
    std::string text = file.text();
    const auto rows = text.find("cmH2O\n0");
    for (std::size_t i = rows; i < text.size(); ++i)
      if (text[i] == '.') text[i] = ',';
    check_flow(trace_of(text));
  }
  SECTION("with the unit of the range if no unit is named") {
    file.units = "";
    std::string text = file.text();
    text.replace(text.find("10.000 V"), 8, "2.000 L/min");
    check_flow(trace_of(text), rows_written, 1e-3 / 60);
    text.replace(text.find("2.000 L/min"), 11, "10.00 \xB5V");  // Windows-1252
    CHECK_THAT(trace_error(text), Contains("no volume or flow column") && Contains("--unit"));
    TraceOptions given;
    given.value_column = "Flow";
    given.unit = "L/s";
    check_flow(trace_of(text, given));
  }
  SECTION("with units in the names, whatever the range of the input is") {
    file.units = "";
    std::string text = file.text();
    text.replace(text.find("Flow"), 4, "Flow (L/s)");
    check_flow(trace_of(text));
  }
  SECTION("with a date in words") {
    file.time = [](int i) { return fmt::format("{:.2f}|3 Dec 2024", 0.01 * i); };
    check_flow(trace_of(file.text()));
  }
  SECTION("without the line of names") {
    std::string text = file.text();
    const auto at = text.find("ChannelTitle");
    text.erase(at, text.find('\n', at) + 1 - at);
    TraceOptions chosen;
    chosen.value_column = "Channel 1";
    check_flow(trace_of(text, chosen));
  }
  SECTION("with a last channel that is empty") {
    std::string text = file.text();
    for (std::size_t at = 0; (at = text.find("\t1.5", at)) != std::string::npos;) text.replace(at, 4, "\t");
    check_flow(trace_of(text));
  }
}

TEST_CASE("Interval= and times that disagree give a note, and the times count", "[faults]") {
  LabChart file;
  file.interval = "0.002 s";
  const Trace trace = trace_of(file.text());
  check_flow(trace);
  CHECK_THAT(trace.notes.at(0), Contains("Interval= says 0.002 s, and the times step by 0.01"));
  file.interval = "external";
  check_flow(trace_of(file.text()));
  file.time = nullptr;
  CHECK_THAT(trace_error(file.text()), Contains("FILE:5: ") && Contains("--rate HZ"));
}

TEST_CASE("Comments at the ends of rows are kept as a note", "[faults]") {
  LabChart file;
  file.tail = [](int i) {
    return i % 40 == 7 ? fmt::format("|#* cough {}", i) : i == 50 ? "|#1 here|it is" : "";
  };
  const Trace trace = trace_of(file.text());
  check_flow(trace);
  const std::string& note = trace.notes.at(0);
  CHECK_THAT(note, Contains("9 comments in the file: 'cough 7' in line 15,") && Contains("and 4 more"));
  CHECK_THAT(note, Contains("'1 here it is' in line 58") || Contains("'1 here?it is' in line 58"));
  CHECK_THAT(trace_error("time_s,flow_L_s\n0,1,#ok\n0.01,1,2\n0.02,1\n"), Contains("FILE:3: 3 cells found"));
}

TEST_CASE("Of several blocks the longest is read unless another is chosen", "[faults]") {
  LabChart one, two, three;
  one.count = 30;
  two.units = "UnitName=|L/min|cmH2O";
  three.count = 40;
  three.interval = "0.02 s";
  three.time = [](int i) { return fmt::format("{:.2f}", 0.02 * i); };
  const std::string file = one.text() + two.text() + "\n" + three.text();
  const Trace longest = trace_of(file);
  check_flow(longest, rows_written, 1e-3 / 60);
  CHECK_THAT(longest.notes.at(0),
             Contains("has 3 blocks, of 0.3, 3, 0.8 s: block 2, the longest, is read (--block 1 "));
  check_flow(trace_of(file, block(1)), 30);
  CHECK(trace_of(file, block(3)).time_s.back() == Approx(0.78));
  CHECK_THROWS_WITH(trace_of(file, block(4)), StartsWith("--block 4: ") && Contains("has 3 blocks"));
  CHECK_THROWS_WITH(trace_of("time_s,volume_ml\n" + trace_rows(), block(2)),
                    StartsWith("--block 2: ") && Contains("is not divided into blocks"));
  TraceOptions rated = block(2);
  rated.rate_hz = 50;
  LabChart untimed = two;
  untimed.time = nullptr;
  CHECK_THAT(trace_of(one.text() + untimed.text(), rated).notes.at(0),
             Contains("'Flow' is read at 50 samples a second, as --rate says, not at 100, as the file says"));
  CHECK_THAT(trace_error(one.text().substr(0, one.text().find("0.00"))),
             Contains("FILE: headers without rows"));

  // Rows without a number at the start of a block are left out, as at the start of any recording.
  std::string with_nan = two.text();
  with_nan.replace(with_nan.find("\t0.000000"), 9, "\tNaN");
  CHECK(trace_of(with_nan).value.size() == rows_written - 1);
}

namespace {

/// A text of AcqKnowledge of two channels.
struct AcqKnowledge {
  std::string rate = "10 msec/sample", delimiter = "\t", end = "\r\n", short_names = "CH1|CH2|",
              counts = "300|300|";
  std::function<std::string(int)> time;

  std::string text() const {
    std::string all =
        "quiet.acq\n" + rate + "\n2 channels\nRespiration - RSP100C\nvolts\nAirflow - TSD117\nL/sec\n";
    if (!short_names.empty()) all += short_names + "\n";
    if (!counts.empty()) all += counts + "\n";
    for (int i = 0; i < rows_written; ++i)
      all += (time ? time(i) + "|" : "") + fmt::format("0.1|{:.6f}|\n", written_flow(i));
    std::string result;
    for (const char c : all) result += c == '|' ? delimiter : c == '\n' ? end : std::string(1, c);
    return result;
  }
};

}  // namespace

TEST_CASE("A text of AcqKnowledge is read with or without times, names and counts", "[faults]") {
  AcqKnowledge file;
  SECTION("the rate in all its spellings") {
    file.rate = GENERATE("10 msec/sample", "0.01 sec/sample", "100 samples/sec", "0.000166666667 min/sample");
    check_flow(trace_of(file.text()));
  }
  SECTION("times in minutes, with six digits") {
    file.time = [](int i) { return fmt::format("{:.6g}", 15 + 0.01 * i / 60); };
    file.short_names = "min|CH1|CH2|";
    file.counts = "|300|300|";
    check_flow(trace_of(file.text()));
  }
  SECTION("no counts, or no names either") {
    file.counts = "";
    file.short_names = GENERATE("CH1|CH2|", "");
    check_flow(trace_of(file.text()));
  }
  SECTION("commas") {
    file.delimiter = ",";
    file.end = "\n";
    check_flow(trace_of(file.text()));
  }
  SECTION("a count that differs") {
    file.counts = "900|900|";
    const Trace trace = trace_of(file.text());
    check_flow(trace);
    bool said = false;
    for (const std::string& note : trace.notes)
      said = said || note.find("counts 900 samples, and 300 rows follow") != std::string::npos;
    CHECK(said);
  }
  SECTION("a channel at half the rate, whose cells are empty in every second row") {
    file.counts = "300|150|";
    std::string text = file.text();
    for (int i = 1; i < rows_written; i += 2) {
      const std::string cell = fmt::format("0.1\t{:.6f}\t\r\n", written_flow(i));
      text.replace(text.find(cell), cell.size(), "0.1\t\t\r\n");
    }
    const Trace trace = trace_of(text);
    REQUIRE(trace.value.size() == rows_written / 2);
    for (int i = 0; i < rows_written / 2; ++i) {
      REQUIRE(trace.time_s[i] == Approx(0.02 * i).margin(1e-9));
      REQUIRE(trace.value[i] == Approx(1e-3 * written_flow(2 * i)).margin(1e-9));
    }
  }
}

TEST_CASE("A table whose logger writes a rate and a number of channels is still a table") {
  const std::string preamble = "Logger 3\n100 samples/s\n2 channels\n";
  CHECK(trace_of(preamble + "time_s,volume_ml\n" + trace_rows()).value.size() == 12);
}
