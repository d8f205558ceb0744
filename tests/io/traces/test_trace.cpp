#include <filesystem>
#include <string>

#include "support/catch.hpp"
#include "support/shared_data.hpp"
#include "support/traces.hpp"
#include "traces/read_trace.hpp"

using namespace trunk;
using namespace trunk::test;

namespace {

TraceOptions columns(const std::string& time, const std::string& value, std::optional<SignalKind> kind = {}) {
  TraceOptions options;
  options.time_column = time;
  options.value_column = value;
  options.kind = kind;
  return options;
}

void check_rows(const Trace& trace, double unit) {
  REQUIRE(trace.time_s.size() == 12);
  REQUIRE(trace.value.size() == 12);
  CHECK(trace.time_s[11] == Approx(0.11));
  CHECK(trace.value[0] == 0.0);
  CHECK(trace.value[11] == Approx(55 * unit));
}

}  // namespace

TEST_CASE("A trace is converted to SI units from the unit in its header") {
  struct Case {
    const char* header;
    SignalKind kind;
    double unit;
  };
  const auto [header, kind, unit] = GENERATE(values<Case>({{"volume_ml", SignalKind::volume, 1e-6},
                                                           {"volume_L", SignalKind::volume, 1e-3},
                                                           {"VOLUME_l", SignalKind::volume, 1e-3},
                                                           {"Volume [ml]", SignalKind::volume, 1e-6},
                                                           {"\"Volume (mL)\"", SignalKind::volume, 1e-6},
                                                           {"flow_L_s", SignalKind::flow, 1e-3},
                                                           {"Flow (L/s)", SignalKind::flow, 1e-3},
                                                           {"flow_L_min", SignalKind::flow, 1e-3 / 60},
                                                           {"Flow [l/min]", SignalKind::flow, 1e-3 / 60},
                                                           {"flow_ml_s", SignalKind::flow, 1e-6}}));
  CAPTURE(header);
  const Trace trace = trace_of(std::string("time_s,") + header + "\n" + trace_rows());
  CHECK(trace.kind == kind);
  check_rows(trace, unit);
  CHECK(trace.sigma_m3.empty());
  CHECK(trace.notes.empty());
}

TEST_CASE("Time is read in seconds, milliseconds and minutes") {
  CHECK(trace_of("Time (s),volume_ml\n" + trace_rows()).time_s[10] == Approx(0.1));
  CHECK(trace_of("time_ms,volume_ml\n" + trace_rows()).time_s[10] == Approx(1e-4));
  CHECK(trace_of("TIME_MIN,volume_ml\n" + trace_rows("e-1,")).time_s[10] == Approx(0.6));
}

TEST_CASE("The same table is read in all ways in which spreadsheets write it") {
  const std::string header = "time_s,volume_ml\n";
  SECTION("comments, blank lines, rows of empty cells") {
    check_rows(trace_of("# a comment\n\n" + header + "# another\n\n ,\n" + trace_rows() + "\n,,\n"), 1e-6);
  }
  SECTION("CRLF") {
    check_rows(trace_of("time_s,volume_ml\r\n" + trace_rows(",", "\r\n")), 1e-6);
  }
  SECTION("CR") {
    check_rows(trace_of("time_s,volume_ml\r" + trace_rows(",", "\r")), 1e-6);
  }
  SECTION("no line end after the last row") {
    auto text = header + trace_rows();
    text.pop_back();
    check_rows(trace_of(text), 1e-6);
  }
  SECTION("UTF-8 mark") {
    check_rows(trace_of("\xEF\xBB\xBF" + header + trace_rows()), 1e-6);
  }
  SECTION("UTF-16, low byte first") {
    check_rows(trace_of(utf16(header + trace_rows(), false)), 1e-6);
  }
  SECTION("UTF-16, high byte first") {
    check_rows(trace_of(utf16(header + trace_rows(), true)), 1e-6);
  }
  SECTION("tab") {
    check_rows(trace_of("time_s\tvolume_ml\n" + trace_rows("\t")), 1e-6);
  }
  SECTION("blanks") {
    check_rows(trace_of("Time (s)   Volume (ml)\n" + trace_rows("   ")), 1e-6);
  }
  SECTION("UTF-16 without its mark") {
    check_rows(trace_of(utf16(header + trace_rows(), false, false)), 1e-6);
    check_rows(trace_of(utf16(header + trace_rows(), true, false)), 1e-6);
  }
  SECTION("semicolon") {
    check_rows(trace_of("time_s;volume_ml\n" + trace_rows(";")), 1e-6);
  }
  SECTION("declared delimiter") {
    check_rows(trace_of("sep=;\r\ntime_s;volume_ml\n" + trace_rows(";")), 1e-6);
  }
  SECTION("quotes and trailing empty columns") {
    check_rows(trace_of("\"time_s\",\"volume_ml\",,\n" + trace_rows(",", ",,\n")), 1e-6);
  }
  SECTION("quoted header with the delimiter inside, other columns of text") {
    check_rows(trace_of("\"subject, name\",time_s,volume_ml\n" +
                        [] {
                          std::string text = trace_rows();
                          for (std::size_t at = 0; at < text.size(); at = text.find('\n', at) + 1)
                            text.insert(at, "Ann,");
                          return text;
                        }()),
               1e-6);
  }
}

TEST_CASE("A decimal comma is accepted if the comma is not the delimiter") {
  std::string table = "Time (s);Volume (ml)\n";
  for (int i = 0; i < 12; ++i) table += "0," + std::to_string(10 + i) + ";+1,25e1\n";
  const Trace trace = trace_of(table);
  CHECK(trace.time_s[3] == Approx(0.13));
  CHECK(trace.value[3] == Approx(12.5e-6));
  CHECK_THAT(trace_error("time_s,volume_ml\n0,00,1,5\n" + trace_rows()),
             Contains("FILE:2: 4 cells found") && Contains("semicolon"));
}

TEST_CASE("Sigma is read if the file has it") {
  std::string table = "time_s,volume_ml,sigma_ml\n" + trace_rows(",", ",7\n");
  const Trace trace = trace_of(table);
  REQUIRE(trace.sigma_m3.size() == 12);
  CHECK(trace.sigma_m3[4] == Approx(7e-6));
  CHECK_THAT(trace_error("time_s,volume_ml,sigma_ml\n" + trace_rows(",", ",0\n")),
             Contains("FILE:2: sigma 0 found") && Contains("above 0"));
}

TEST_CASE("Flow is preferred to volume with a note, and options change this") {
  const std::string table = "time_s,volume_L,flow_L_s,volume_from_flow_L\n" + trace_rows(",", ",2,3\n");
  const Trace automatic = trace_of(table);
  CHECK(automatic.kind == SignalKind::flow);
  CHECK(automatic.value[1] == Approx(2e-3));
  REQUIRE(automatic.notes.size() == 1);
  CHECK_THAT(automatic.notes[0], Contains("flow_L_s") && Contains("volume_L"));

  const Trace volume = trace_of(table, columns("", "", SignalKind::volume));
  CHECK(volume.kind == SignalKind::volume);
  CHECK(volume.value[1] == Approx(5e-3));

  const Trace named = trace_of(table, columns("", "volume_from_flow_L"));
  CHECK(named.kind == SignalKind::volume);
  CHECK(named.value[1] == Approx(3e-3));

  CHECK_THAT(trace_error(table, columns("", "volum")),
             Contains("FILE:1: no column 'volum'") && Contains("'volume_from_flow_L'"));
  CHECK(trace_of(table, columns("", "volume")).value == volume.value);  // without its unit
  CHECK(trace_of(table, columns("", "2")).value == volume.value);       // by its number
  CHECK_THAT(trace_error("time_s,strap\n" + trace_rows(), columns("", "strap")),
             Contains("FILE:1:") && Contains("'strap'") && Contains("unit"));
  const TraceOptions wrong_time = columns("volume_L", "");
  CHECK_THAT(trace_error(table, wrong_time), Contains("FILE:1:") && Contains("unit of time"));
  const TraceOptions flow = columns("", "", SignalKind::flow);
  CHECK_THAT(trace_error("time_s,volume_L\n" + trace_rows(), flow),
             Contains("FILE:1: no flow column") && Contains("'volume_L'"));
}

TEST_CASE("A file that cannot be read is refused") {
  const auto folder = std::filesystem::temp_directory_path();
  CHECK_THROWS_WITH(read_trace(folder / "trunk_no_such.csv"), Contains("trunk_no_such.csv: no such file"));
  CHECK_THROWS_WITH(read_trace(folder), Contains("directory"));
  CHECK_THAT(trace_error(""), Contains("FILE: the file is empty"));
  CHECK_THAT(trace_error("\xEF\xBB\xBF"), Contains("FILE: the file is empty"));
  CHECK_THAT(trace_error("# only\n\n# comments\n"), Contains("FILE: only blank lines and comments"));
  CHECK_THAT(trace_error("time_s,volume_ml\n0,1\n" + std::string("\0x", 2)),
             Contains("FILE:3: NUL byte") && Contains("binary"));
  CHECK_THAT(trace_error("time_s,volume_ml\n" + std::string(1'000'001, '1') + "\n"),
             Contains("FILE:2: a line of 1000001 bytes"));
}

TEST_CASE("A header that cannot be used is refused with its line") {
  CHECK_THAT(trace_error("# made by hand\n" + trace_rows()),
             Contains("FILE:2: the first row starts with the number '0.00'") && Contains("header"));
  CHECK_THAT(trace_error("time_s,volume_ml\n\n"), Contains("FILE:1: a header without rows"));
  CHECK_THAT(trace_error("sample,volume_ml\n" + trace_rows()),
             Contains("FILE:1: no time column among 'sample', 'volume_ml'") && Contains("time_s"));
  CHECK_THAT(trace_error("time,volume_ml\n" + trace_rows()),
             Contains("FILE:1:") && Contains("'time' has no unit: name it time_s"));
  CHECK_THAT(
      trace_error("time_s,strap_au\n" + trace_rows()),
      Contains("FILE:1: no volume or flow column among 'time_s', 'strap_au'") && Contains("flow_L_min"));
  CHECK_THAT(trace_error("time_s,Volume\n" + trace_rows()),
             Contains("'Volume' has no unit: name it volume_ml"));
  CHECK_THAT(trace_error("time_s,flow\n" + trace_rows()), Contains("'flow' has no unit: name it flow_L_s"));
  CHECK_THAT(trace_error("time_s,volum_ml\n" + trace_rows()),
             Contains("if 'volum_ml' is meant, name it volume_ml"));
  CHECK_THAT(trace_error("time_s,volume_gal\n" + trace_rows()),
             Contains("unit of 'volume_gal' is not known"));
  CHECK_THAT(trace_error("time_s:volume_ml\n" + trace_rows(":")),
             Contains("FILE:1:") && Contains("separate the columns by comma"));
  CHECK_THAT(trace_error("time_s,volume_ml,volume_L\n" + trace_rows(",", ",1\n")),
             Contains("FILE:1: two columns") && Contains("'volume_ml' and 'volume_L'"));
  CHECK_THAT(trace_error("time_s,\"volume_ml\n" + trace_rows()),
             Contains("FILE:1:") && Contains("double quote"));
}

TEST_CASE("A row that cannot be used is refused with its line") {
  const std::string head = "# comment\ntime_s,volume_ml\n" + trace_rows();  // rows end at line 14
  // More rows than are bridged, so that it is an error.
  const auto error = [&](const std::string& row) {
    std::string text = head;
    for (int i = 0; i < 30; ++i) text += row + "\n";
    return trace_error(text);
  };
  CHECK_THAT(error("0.12"), Contains("FILE:15: 1 cell(s) found") &&
                                Contains("expected at least 2, since column 'volume_ml' is number 2"));
  CHECK_THAT(error("0.12,"), Contains("FILE:15: 1 cell(s) found"));
  CHECK_THAT(error(",3"), Contains("FILE:15: empty cell") && Contains("'time_s'"));
  CHECK_THAT(error("0.12,1,2"), Contains("FILE:15: 3 cells found; expected 2"));
  CHECK_THAT(error("0.12,12 ml"),
             Contains("FILE:15: '12 ml' found in column 'volume_ml'") && Contains("number"));
  CHECK_THAT(error("0.12," + std::string(500, 'x')), Contains(std::string(40, 'x') + "...'"));
  CHECK_THAT(error("0.12,\x1B[31m"), Contains("FILE:15: '?[31m'"));
  CHECK_THAT(error("0.12,nan"), Contains("FILE:15: 'nan'") && Contains("finite"));
  CHECK_THAT(error("inf,1"), Contains("FILE:15: 'inf'") && Contains("finite"));
  CHECK_THAT(error("0.12,1e999"), Contains("FILE:15: '1e999'") && Contains("finite"));
  CHECK_THAT(error("0.12,--1"), Contains("FILE:15: '--1'") && Contains("the first of 30 samples"));
}

TEST_CASE("Sampling that cannot be used is refused with its line") {
  const std::string head = "time_s,volume_ml\n" + trace_rows();  // rows end at line 13, at 0.11 s
  CHECK_THAT(trace_error(head + "0.10,1\n"),
             Contains("FILE:14: time 0.1 found after 0.11") && Contains("increase"));
  CHECK_THAT(trace_error(head + "0.11,1\n"), Contains("FILE:14: time 0.11 found after 0.11"));
  CHECK_THAT(trace_error(head + "0.61,1\n"), Contains("FILE:14: a gap of 0.5 s between 0.11 s and 0.61 s"));
  CHECK(trace_error(head + "0.35,1\n").empty());  // 24 steps, but under 0.25 s
  CHECK_THAT(trace_error("time_s,volume_ml\n" + trace_rows(",", "\n", 9)),
             Contains("FILE: 9 samples found") && Contains("at least 10"));
  CHECK(trace_error("time_s,volume_ml\n" + trace_rows(",", "\n", 10)).empty());
}

TEST_CASE("Real recordings are read", "[shared][io]") {
  const Trace trace = read_trace(test::shared_file("traces/cant_Subject03_0cmH2O_0mL.csv"));
  CHECK(trace.kind == SignalKind::flow);
  CHECK(trace.time_s.size() == 4362);
  CHECK(trace.time_s.back() == Approx(43.61));
  CHECK(trace.value.front() == Approx(-0.462476e-3));
  CHECK(trace.notes.size() == 1);
}
