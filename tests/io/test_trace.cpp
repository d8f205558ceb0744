#include <catch2/catch.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>

#include "errors/input_error.hpp"
#include "io/trace.hpp"

using namespace trunk;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

// A file in the temporary folder, removed with the object.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& content) {
    std::random_device random;
    path_ = std::filesystem::temp_directory_path() /
            ("trunk_trace_" + std::to_string(random()) + std::to_string(random()) + ".csv");
    std::ofstream(path_, std::ios::binary) << content;
  }
  ~TemporaryFile() { std::filesystem::remove(path_); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

Trace read_text(const std::string& content, const TraceOptions& options = {}) {
  const TemporaryFile file(content);
  return read_trace(file.path(), options);
}

// The error of a content, with the file's name replaced by "FILE"; "" when there was none.
std::string error_of(const std::string& content, const TraceOptions& options = {}) {
  const TemporaryFile file(content);
  try {
    read_trace(file.path(), options);
  } catch (const InputError& error) {
    std::string text = error.what();
    const std::string name = file.path().string();
    REQUIRE_THAT(text, StartsWith(name + ":"));
    REQUIRE(text.find('\n') == std::string::npos);
    return text.replace(0, name.size(), "FILE");
  }
  return "";
}

// Twelve rows "0.00,0" "0.01,5" ...: times 10 ms apart, values 5 i.
std::string rows(const std::string& delimiter = ",", const std::string& end = "\n", int count = 12) {
  std::string text;
  for (int i = 0; i < count; ++i)
    text +=
        "0." + std::string(i < 10 ? "0" : "") + std::to_string(i) + delimiter + std::to_string(5 * i) + end;
  return text;
}

std::string utf16(const std::string& ascii, bool big_endian) {
  std::string bytes = big_endian ? "\xFE\xFF" : "\xFF\xFE";
  for (const char c : ascii) bytes += big_endian ? std::string{'\0', c} : std::string{c, '\0'};
  return bytes;
}

void check_rows(const Trace& trace, double unit) {
  REQUIRE(trace.time_s.size() == 12);
  REQUIRE(trace.value.size() == 12);
  CHECK(trace.time_s[11] == Approx(0.11));
  CHECK(trace.value[0] == 0.0);
  CHECK(trace.value[11] == Approx(55 * unit));
}

}  // namespace

TEST_CASE("a trace is read into SI units by the unit in its header") {
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
  const Trace trace = read_text(std::string("time_s,") + header + "\n" + rows());
  CHECK(trace.kind == kind);
  check_rows(trace, unit);
  CHECK(trace.sigma_m3.empty());
  CHECK(trace.notes.empty());
}

TEST_CASE("time is read in seconds, milliseconds and minutes") {
  CHECK(read_text("Time (s),volume_ml\n" + rows()).time_s[10] == Approx(0.1));
  CHECK(read_text("time_ms,volume_ml\n" + rows()).time_s[10] == Approx(1e-4));
  CHECK(read_text("TIME_MIN,volume_ml\n" + rows()).time_s[10] == Approx(6.0));
}

TEST_CASE("the ways in which spreadsheets write the same table") {
  const std::string header = "time_s,volume_ml\n";
  SECTION("comments, blank lines, rows of empty cells") {
    check_rows(read_text("# a comment\n\n" + header + "# another\n\n ,\n" + rows() + "\n,,\n"), 1e-6);
  }
  SECTION("CRLF") {
    check_rows(read_text("time_s,volume_ml\r\n" + rows(",", "\r\n")), 1e-6);
  }
  SECTION("CR") {
    check_rows(read_text("time_s,volume_ml\r" + rows(",", "\r")), 1e-6);
  }
  SECTION("no line end after the last row") {
    auto text = header + rows();
    text.pop_back();
    check_rows(read_text(text), 1e-6);
  }
  SECTION("UTF-8 mark") {
    check_rows(read_text("\xEF\xBB\xBF" + header + rows()), 1e-6);
  }
  SECTION("UTF-16, low byte first") {
    check_rows(read_text(utf16(header + rows(), false)), 1e-6);
  }
  SECTION("UTF-16, high byte first") {
    check_rows(read_text(utf16(header + rows(), true)), 1e-6);
  }
  SECTION("tab") {
    check_rows(read_text("time_s\tvolume_ml\n" + rows("\t")), 1e-6);
  }
  SECTION("semicolon") {
    check_rows(read_text("time_s;volume_ml\n" + rows(";")), 1e-6);
  }
  SECTION("declared delimiter") {
    check_rows(read_text("sep=;\r\ntime_s;volume_ml\n" + rows(";")), 1e-6);
  }
  SECTION("quotes and trailing empty columns") {
    check_rows(read_text("\"time_s\",\"volume_ml\",,\n" + rows(",", ",,\n")), 1e-6);
  }
  SECTION("quoted header with the delimiter inside, other columns of text") {
    check_rows(read_text("\"subject, name\",time_s,volume_ml\n" +
                         [] {
                           std::string text = rows();
                           for (std::size_t at = 0; at < text.size(); at = text.find('\n', at) + 1)
                             text.insert(at, "Ann,");
                           return text;
                         }()),
               1e-6);
  }
}

TEST_CASE("a decimal comma counts where the comma is no delimiter") {
  std::string table = "Time (s);Volume (ml)\n";
  for (int i = 0; i < 12; ++i) table += std::to_string(i) + ",5;+1,25e1\n";
  const Trace trace = read_text(table);
  CHECK(trace.time_s[3] == Approx(3.5));
  CHECK(trace.value[3] == Approx(12.5e-6));
  CHECK_THAT(error_of("time_s,volume_ml\n0,00,1,5\n" + rows()),
             Contains("FILE:2: 4 cells found") && Contains("semicolon"));
}

TEST_CASE("sigma is read where given") {
  std::string table = "time_s,volume_ml,sigma_ml\n" + rows(",", ",7\n");
  const Trace trace = read_text(table);
  REQUIRE(trace.sigma_m3.size() == 12);
  CHECK(trace.sigma_m3[4] == Approx(7e-6));
  CHECK_THAT(error_of("time_s,volume_ml,sigma_ml\n" + rows(",", ",0\n")),
             Contains("FILE:2: sigma 0 found") && Contains("above 0"));
}

TEST_CASE("flow is preferred to volume, and said so; options choose otherwise") {
  const std::string table = "time_s,volume_L,flow_L_s,volume_from_flow_L\n" + rows(",", ",2,3\n");
  const Trace automatic = read_text(table);
  CHECK(automatic.kind == SignalKind::flow);
  CHECK(automatic.value[1] == Approx(2e-3));
  REQUIRE(automatic.notes.size() == 1);
  CHECK_THAT(automatic.notes[0], Contains("flow_L_s") && Contains("volume_L"));

  const Trace volume =
      read_text(table, {.time_column = "", .value_column = "", .prefer = SignalKind::volume});
  CHECK(volume.kind == SignalKind::volume);
  CHECK(volume.value[1] == Approx(5e-3));

  const Trace named =
      read_text(table, {.time_column = "", .value_column = "volume_from_flow_L", .prefer = {}});
  CHECK(named.kind == SignalKind::volume);
  CHECK(named.value[1] == Approx(3e-3));

  const TraceOptions absent{.time_column = "", .value_column = "volume", .prefer = {}};
  CHECK_THAT(error_of(table, absent),
             Contains("FILE:1: no column 'volume'") && Contains("'volume_from_flow_L'"));
  const TraceOptions no_unit{.time_column = "", .value_column = "belt", .prefer = {}};
  CHECK_THAT(error_of("time_s,belt\n" + rows(), no_unit),
             Contains("FILE:1:") && Contains("'belt'") && Contains("unit"));
  const TraceOptions wrong_time{.time_column = "volume_L", .value_column = "", .prefer = {}};
  CHECK_THAT(error_of(table, wrong_time), Contains("FILE:1:") && Contains("unit of time"));
  const TraceOptions flow{.time_column = "", .value_column = "", .prefer = SignalKind::flow};
  CHECK_THAT(error_of("time_s,volume_L\n" + rows(), flow),
             Contains("FILE:1: no flow column") && Contains("'volume_L'"));
}

TEST_CASE("what is no readable file") {
  const auto folder = std::filesystem::temp_directory_path();
  CHECK_THROWS_WITH(read_trace(folder / "trunk_no_such.csv"), Contains("trunk_no_such.csv: no such file"));
  CHECK_THROWS_WITH(read_trace(folder), Contains("directory"));
  CHECK_THAT(error_of(""), Contains("FILE: the file is empty"));
  CHECK_THAT(error_of("\xEF\xBB\xBF"), Contains("FILE: the file is empty"));
  CHECK_THAT(error_of("# only\n\n# comments\n"), Contains("FILE: only blank lines and comments"));
  CHECK_THAT(error_of("time_s,volume_ml\n0,1\n" + std::string("\0x", 2)),
             Contains("FILE:3: NUL byte") && Contains("binary"));
  CHECK_THAT(error_of("time_s,volume_ml\n" + std::string(1'000'001, '1') + "\n"),
             Contains("FILE:2: a line of 1000001 bytes"));
}

TEST_CASE("what is no usable header") {
  CHECK_THAT(error_of("# made by hand\n" + rows()),
             Contains("FILE:2: the first row starts with the number '0.00'") && Contains("header"));
  CHECK_THAT(error_of("time_s,volume_ml\n\n"), Contains("FILE:1: a header without rows"));
  CHECK_THAT(error_of("sample,volume_ml\n" + rows()),
             Contains("FILE:1: no time column among 'sample', 'volume_ml'") && Contains("time_s"));
  CHECK_THAT(error_of("time,volume_ml\n" + rows()),
             Contains("FILE:1:") && Contains("'time' has no unit: name it time_s"));
  CHECK_THAT(
      error_of("time_s,belt_au\n" + rows()),
      Contains("FILE:1: no volume or flow column among 'time_s', 'belt_au'") && Contains("flow_L_min"));
  CHECK_THAT(error_of("time_s,Volume\n" + rows()), Contains("'Volume' has no unit: name it volume_ml"));
  CHECK_THAT(error_of("time_s,flow\n" + rows()), Contains("'flow' has no unit: name it flow_L_s"));
  CHECK_THAT(error_of("time_s,volum_ml\n" + rows()),
             Contains("if column 'volum_ml' is meant, name it volume_ml"));
  CHECK_THAT(error_of("time_s,volume_m3\n" + rows()), Contains("unit of column 'volume_m3' is not known"));
  CHECK_THAT(error_of("time_s volume_ml\n" + rows(" ")),
             Contains("FILE:1:") && Contains("separate the columns by comma"));
  CHECK_THAT(error_of("time_s,volume_ml,volume_L\n" + rows(",", ",1\n")),
             Contains("FILE:1: two columns") && Contains("'volume_ml' and 'volume_L'"));
  CHECK_THAT(error_of("time_s,\"volume_ml\n" + rows()), Contains("FILE:1:") && Contains("double quote"));
}

TEST_CASE("what is no usable row, with its line") {
  const std::string head = "# comment\ntime_s,volume_ml\n" + rows();  // rows end at line 14
  CHECK_THAT(error_of(head + "0.12\n"),
             Contains("FILE:15: 1 cell(s) found") && Contains("'volume_ml' is number 2"));
  CHECK_THAT(error_of(head + "0.12,\n"), Contains("FILE:15: 1 cell(s) found"));
  CHECK_THAT(error_of(head + ",3\n"), Contains("FILE:15: empty cell") && Contains("'time_s'"));
  CHECK_THAT(error_of(head + "0.12,1,2\n"), Contains("FILE:15: 3 cells found; expected 2"));
  CHECK_THAT(error_of(head + "0.12,12 ml\n"),
             Contains("FILE:15: '12 ml' found in column 'volume_ml'") && Contains("number"));
  CHECK_THAT(error_of(head + "0.12," + std::string(500, 'x') + "\n"),
             Contains(std::string(40, 'x') + "...'"));
  CHECK_THAT(error_of(head + "0.12,\x1B[31m\n"), Contains("FILE:15: '?[31m'"));
  CHECK_THAT(error_of(head + "0.12,nan\n"), Contains("FILE:15: 'nan'") && Contains("finite"));
  CHECK_THAT(error_of(head + "inf,1\n"), Contains("FILE:15: 'inf'") && Contains("finite"));
  CHECK_THAT(error_of(head + "0.12,1e999\n"), Contains("FILE:15: '1e999'") && Contains("finite"));
  CHECK_THAT(error_of(head + "0.12,--1\n"), Contains("FILE:15: '--1'"));
}

TEST_CASE("what is no usable sampling") {
  const std::string head = "time_s,volume_ml\n" + rows();  // rows end at line 13, at 0.11 s
  CHECK_THAT(error_of(head + "0.10,1\n"),
             Contains("FILE:14: time 0.1 found after 0.11") && Contains("increase"));
  CHECK_THAT(error_of(head + "0.11,1\n"), Contains("FILE:14: time 0.11 found after 0.11"));
  CHECK_THAT(error_of(head + "0.61,1\n"), Contains("FILE:14: a gap of 0.5 s between 0.11 s and 0.61 s"));
  CHECK(error_of(head + "0.35,1\n").empty());  // 24 steps, but under 0.25 s
  CHECK_THAT(error_of("time_s,volume_ml\n" + rows(",", "\n", 9)),
             Contains("FILE: 9 samples found") && Contains("at least 10"));
  CHECK(error_of("time_s,volume_ml\n" + rows(",", "\n", 10)).empty());
}

#ifdef TRUNK_SHARED_DATA
TEST_CASE("real recordings are read") {
  const std::filesystem::path file =
      std::filesystem::path(TRUNK_SHARED_DATA) / "traces" / "cant_Subject03_0cmH2O_0mL.csv";
  if (!std::filesystem::exists(file)) {
    WARN("skipped: " << file.string() << " is not there");
    return;
  }
  const Trace trace = read_trace(file);
  CHECK(trace.kind == SignalKind::flow);
  CHECK(trace.time_s.size() == 4362);
  CHECK(trace.time_s.back() == Approx(43.61));
  CHECK(trace.value.front() == Approx(-0.462476e-3));
  CHECK(trace.notes.size() == 1);
}
#endif
