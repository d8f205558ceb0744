#include <fmt/format.h>

#include <cmath>
#include <functional>

#include "support/catch.hpp"
#include "support/traces.hpp"
#include "tables/clock_time.hpp"
#include "tables/text_cells.hpp"

using namespace trunk;
using namespace trunk::test;

namespace {

double flow_of_row(int i) {
  return 0.5 * std::sin(0.03 * i);
}

/// A header and `count` rows, each written from its number.
std::string rows_of(const std::string& header, int count, const std::function<std::string(int)>& row) {
  std::string text = header + "\n";
  for (int i = 0; i < count; ++i) text += row(i) + "\n";
  return text;
}

std::string note_with(const Trace& trace, const std::string& words) {
  for (const std::string& note : trace.notes)
    if (note.find(words) != std::string::npos) return note;
  return "";
}

TraceOptions in_encoding(const std::string& name) {
  TraceOptions options;
  options.encoding = name;
  return options;
}

}  // namespace

TEST_CASE("Clocks of ventilators, spreadsheets and loggers are understood", "[faults]") {
  const double noon = 12 * 3600.0;
  CHECK(clock_time("00:10:11:403")->seconds == Approx(611.403));
  CHECK(clock_time("1:05:07.02 PM")->seconds == Approx(noon + 3907.02));
  CHECK(clock_time("1:05:07,02 p. m.")->seconds == Approx(noon + 3907.02));
  CHECK(clock_time("午後 1:05:07.02")->seconds == Approx(noon + 3907.02));
  CHECK(clock_time("2024/3/31 上午12:05:07")->seconds == Approx(1711843200.0 + 307));
  CHECK(clock_time("12:05:07 am")->seconds == Approx(307));
  CHECK(clock_time("12:05:07\xE2\x80\xAFPM")->seconds == Approx(noon + 307));
  CHECK(clock_time("13:05 PM")->seconds == Approx(noon + 3900));
  CHECK(clock_time("1:05 PM")->seconds == Approx(noon + 3900));
  CHECK(clock_time("3/31/2024 2:05:07 PM")->seconds == Approx(1711893907.0));
  CHECK(clock_time("31-Mar-2024 14:05:07.5")->seconds == Approx(1711893907.5));
  CHECK(clock_time("2024-03-31 14:05:07 UTC")->seconds == Approx(1711893907.0));
  CHECK(clock_time("2024-03-31 14:05:07 GMT-1")->seconds == Approx(1711893907.0 + 3600));
  CHECK(clock_time("1 days 02:05:07.5")->seconds == Approx(86400 + 7507.5));
  // One instant before and one after summer time ends in Paris.
  CHECK(clock_time("2024-10-27 02:00:00.5+01:00")->seconds -
            clock_time("2024-10-27T02:59:59.5+0200")->seconds ==
        Approx(1));

  // Whatever the column is called.
  const Trace laiks = trace_of(rows_of("Laiks;flow_L_s;stan", 20, [](int i) {
    return fmt::format("12:00:00.{:02};{};wdech", i, flow_of_row(i));
  }));
  CHECK(laiks.time_s[19] == Approx(0.19));
  CHECK_THAT(laiks.notes.at(0), Contains("'Laiks' is taken as the time, since it alone has clock times"));

  const auto read = [](const std::function<std::string(int)>& clock) {
    return trace_of(
        rows_of("Time;flow_L_s", 200, [&](int i) { return fmt::format("{};{}", clock(i), flow_of_row(i)); }));
  };
  for (const Trace& trace :
       {read([](int i) { return fmt::format("00:10:{:02}:{:03}", 58 + i / 100, i % 100 * 10); }),
        read([](int i) {
          const int t = i + 5950;  // over noon
          return fmt::format("{}:{:02}:{:02}.{:02} {}", t < 6000 ? 11 : 12, t < 6000 ? 59 : 0, t / 100 % 60,
                             t % 100, t < 6000 ? "AM" : "PM");
        }),
        read([](int i) {
          return fmt::format("2024-10-27T0{}:{:02}.{:02}+0{}:00", i < 100 ? "2:59" : "2:00",
                             i < 100 ? 59 : i / 100 - 1, i % 100, i < 100 ? 2 : 1);
        })}) {
    CAPTURE(trace.time_s.size());
    REQUIRE(trace.time_s.size() > 100);
    for (std::size_t i = 0; i < 100; ++i)
      REQUIRE(trace.time_s[i] == Approx(0.01 * static_cast<double>(i)).margin(1e-6));
  }
}

TEST_CASE("Header cells may hold line breaks", "[faults]") {
  const std::string end = GENERATE("\n", "\r\n");
  const std::string header =
      "\"Time" + end + "(s)\",\"Flow" + end + "\"\"mouth\"\"" + end + "(L/s)\",\"a" + end + "b\"" + end;
  const Trace trace = trace_of(header + trace_rows(",", ",3" + end));
  CHECK(trace.value.back() == Approx(55e-3));
  CHECK_THAT(trace_error(header + "0,1,2" + end + "0.01,x,2" + end + trace_rows(",", ",3" + end)),
             Contains(":"));

  TextLines lines("f", "\"a\nb\nc\",1\nnext\n\"lone\n5\" pipe\n");
  std::string_view line;
  REQUIRE(lines.next(line));
  CHECK(line == "\"a\nb\nc\",1");
  CHECK(lines.number() == 1);
  REQUIRE(lines.next(line));
  CHECK(lines.number() == 4);
  REQUIRE(lines.next(line));
  CHECK(line == "\"lone");
  REQUIRE(lines.next(line));
  CHECK(line == "5\" pipe");
  CHECK_FALSE(lines.next(line));

  // A lone quote does not swallow what follows.
  std::string lone = "\"never closed\n";
  for (int i = 0; i < 100; ++i) lone += "1,2\n";
  TextLines after("f", lone);
  REQUIRE(after.next(line));
  CHECK(line == "\"never closed");
}

TEST_CASE("Channels at different rates may share the rows of a table", "[faults]") {
  const auto cell = [](int i, int every, int phase) {
    return i % every == phase ? fmt::format("{:.6f}", flow_of_row(i)) : std::string();
  };
  const int every = GENERATE(2, 4);
  const Trace trace = trace_of(rows_of("time_s,flow_L_s,Poes_cmH2O", 800, [&](int i) {
    return fmt::format("{:.3f},{},{}", 0.005 * i, cell(i, every, 1), cell(i, every, 0));
  }));
  REQUIRE(trace.value.size() == static_cast<std::size_t>(800 / every));
  for (std::size_t i = 0; i < trace.value.size(); ++i) {
    const int row = 1 + every * static_cast<int>(i);
    REQUIRE(trace.time_s[i] == Approx(0.005 * row));
    REQUIRE(trace.value[i] == Approx(1e-3 * flow_of_row(row)).margin(1e-9));
  }
  CHECK_THAT(note_with(trace, "evenly spaced"),
             Contains(fmt::format("a number in {} of 800 rows", 800 / every)));
  // A pressure in the rows between is interpolated.
  REQUIRE(trace.channels.size() == 1);
  CHECK(trace.channels[0].value[20] == Approx(98.0665 * flow_of_row(1 + 20 * every)).margin(0.3));

  SECTION("without times, the rate counts the rows") {
    TraceOptions options;
    options.rate_hz = 200;
    const Trace rated =
        trace_of(rows_of("ecg_mV,flow_L_s", 800, [&](int i) { return "0.1," + cell(i, every, 0); }), options);
    CHECK(rated.time_s[10] == Approx(0.005 * 10 * every));
  }
  SECTION("only the signal beside the times") {
    CHECK(trace_of(rows_of("time_s,flow_L_s", 800, [&](int i) {
            return fmt::format("{:.3f},{}", 0.005 * i, cell(i, every, 0));
          })).value.size() == static_cast<std::size_t>(800 / every));
  }
  SECTION("two loggers in the order of time") {
    // 100 Hz and 30 Hz: rows of one or of the other.
    std::string rows = "time_s,flow_L_s,ecg\n";
    int slow = 0;
    for (int i = 0; i < 400; ++i) {
      for (; slow / 30.0 < 0.01 * i; ++slow) rows += fmt::format("{:.5f},,{}\n", slow / 30.0 + 1e-4, slow);
      rows += fmt::format("{:.5f},{:.6f},\n", 0.01 * i, flow_of_row(i));
    }
    CHECK(trace_of(rows).value.size() == 400);
  }
  SECTION("samples that are missing here and there are still missing") {
    CHECK_THAT(trace_error(
                   rows_of("time_s,flow_L_s", 800,
                           [&](int i) { return fmt::format("{:.3f},{}", 0.005 * i, i % 7 < 2 ? "" : "1"); })),
               Contains("more than a tenth"));
  }
}

TEST_CASE("A text may be in the encoding that the user names", "[faults]") {
  // Time (s), flow (L/s) in Japanese, in Shift_JIS; the second byte of one letter is a backslash.
  const std::string japanese =
      "\x8E\x9E\x8A\xD4(s),\x97\xAC\x97\xCA(L/s),\x95\x5C\n" + trace_rows(",", ",1\n");
  TraceOptions options = in_encoding("Shift_JIS");
  options.time_column = "1";
  options.value_column = "\xE6\xB5\x81\xE9\x87\x8F(L/s)";
  CHECK(trace_of(japanese, options).value.back() == Approx(55e-3));
  CHECK_THAT(trace_error(japanese), Contains("--encoding Shift_JIS"));
  options.encoding = "cp932";
  CHECK(trace_of(japanese, options).value.size() == 12);
  options.encoding = "EUC-JP";
  CHECK_THAT(trace_error(japanese, options), Contains("FILE:1: byte 0x8e is not EUC-JP text"));
  for (const char* name : {"Shift-JIS-X", "", "../../tmp/x", "UTF-8//IGNORE", "no encoding"}) {
    if (*name == '\0') continue;
    options.encoding = name;
    CHECK_THROWS_WITH(
        trace_of(japanese, options),
        StartsWith(fmt::format("--encoding {}: no encoding", name)) && Contains("`iconv -l` lists all"));
  }
  const std::string plain = "time_s,volume_ml\n" + trace_rows();
  CHECK(trace_of(utf16(plain, false), in_encoding("UTF-16")).value.size() == 12);
  CHECK(trace_of(utf16(plain, true, false), in_encoding("UTF-16BE")).value.size() == 12);
  CHECK(trace_of("\xEF\xBB\xBF" + plain, in_encoding("UTF-8")).value.size() == 12);
}

TEST_CASE("Belts of thorax and abdomen are understood, and one may be chosen", "[faults]") {
  const auto text = [](const std::string& header) {
    return rows_of(header, 60, [](int i) { return fmt::format("{:.2f},{},{}", 0.01 * i, i, -i); });
  };
  for (const std::string header :
       {"time_s,Thorax,Abdomen", "time_s,RC,AB", "time_s,abdo belt,chest belt", "time_s,ABDO,THOR"}) {
    CAPTURE(header);
    CHECK_THAT(trace_error(text(header)),
               Contains("belt of the thorax") && Contains("choose one of them with --belt"));
  }
  TraceOptions one;
  one.kind = SignalKind::belt;
  one.value_column = "Abdomen";
  CHECK(trace_of(text("time_s,Thorax,Abdomen"), one).value.back() == -59);
  CHECK_THAT(trace_error(text("time_s,belt 1,belt 2")), Contains("have the same meaning"));
}

TEST_CASE("A table of breaths is named for what it is", "[faults]") {
  const std::string breaths = rows_of(
      "t,Rf,VT,VE,VO2,VCO2\nhh:mm:ss,1/min,L(btps),L/min,mL/min,mL/min", 30,
      [](int i) { return fmt::format("00:{:02}:{:02},14.3,0.517,7.39,250,210", 4 * i / 60, 4 * i % 60); });
  CHECK_THAT(trace_error(breaths), Contains("each row seems to be a breath") && Contains("metabolic cart") &&
                                       Contains("'VT', 'VE', 'VO2'"));
  // Also without such names: breaths are not evenly spaced.
  TraceOptions volume;
  volume.value_column = "2";
  CHECK_THAT(
      trace_error(rows_of("time_s,VT (L)", 40,
                          [](int i) { return fmt::format("{:.2f},0.5", 4.1 * i + 0.7 * std::sin(1.7 * i)); }),
                  volume),
      Contains("if each row is a breath"));
  TraceOptions chosen;
  chosen.value_column = "VT";
  chosen.kind = SignalKind::volume;
  CHECK_THAT(trace_error(breaths, chosen),
             Contains("a sample every 4 s") && Contains("if each row is a breath"));
}
