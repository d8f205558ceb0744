#include <matio.h>

#include <cmath>
#include <fstream>
#include <iterator>

#include "support/catch.hpp"
#include "support/edf_file.hpp"
#include "support/traces.hpp"

using namespace trunk;
using namespace trunk::test;

namespace {

constexpr std::size_t samples = 400;

double wave(int i) {
  return std::sin(0.03 * i);
}

/// Writes variables into a MAT-file by libmatio itself.
class MatWriter {
 public:
  MatWriter(const std::filesystem::path& path, mat_ft version)
      : file_(Mat_CreateVer(path.c_str(), nullptr, version)) {
    REQUIRE(file_ != nullptr);
  }
  ~MatWriter() { Mat_Close(file_); }
  MatWriter(const MatWriter&) = delete;
  MatWriter& operator=(const MatWriter&) = delete;

  static matvar_t* matrix(const char* name, std::vector<double> values, std::size_t rows) {
    std::size_t size[] = {rows, values.size() / rows};
    return Mat_VarCreate(name, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, size, values.data(), 0);
  }
  static matvar_t* text(const char* name, std::string characters, std::size_t rows = 1) {
    std::size_t size[] = {rows, characters.size() / rows};
    return Mat_VarCreate(name, MAT_C_CHAR, MAT_T_UTF8, 2, size, characters.data(), 0);
  }
  void write(matvar_t* variable, bool compressed = true) {
    REQUIRE(Mat_VarWrite(file_, variable, compressed ? MAT_COMPRESSION_ZLIB : MAT_COMPRESSION_NONE) == 0);
    Mat_VarFree(variable);
  }
  void write_struct(const char* name, std::vector<const char*> fields, const std::vector<matvar_t*>& values) {
    fields.push_back(nullptr);
    std::size_t size[] = {1, 1};
    matvar_t* record = Mat_VarCreateStruct2(name, 2, size, fields.data());
    for (std::size_t i = 0; i < values.size(); ++i)
      Mat_VarSetStructFieldByName(record, fields[i], 0, values[i]);
    write(record);
  }

 private:
  mat_t* file_;
};

std::vector<double> waves(double scale = 1) {
  std::vector<double> values(samples);
  for (std::size_t i = 0; i < samples; ++i) values[i] = scale * wave(static_cast<int>(i));
  return values;
}

std::vector<double> hundredths_of_seconds() {
  std::vector<double> time(samples);
  for (std::size_t i = 0; i < samples; ++i) time[i] = 0.01 * static_cast<double>(i);
  return time;
}

void check_waves(const Trace& trace, double unit, double rate_hz = 100, double accuracy = 1e-12) {
  REQUIRE(trace.value.size() == samples);
  for (std::size_t i = 0; i < samples; ++i) {
    REQUIRE(trace.time_s[i] == Approx(static_cast<double>(i) / rate_hz).margin(1e-12));
    REQUIRE(trace.value[i] == Approx(unit * wave(static_cast<int>(i))).margin(accuracy * unit));
  }
}

TraceOptions picked(const std::string& value, const std::string& unit = "") {
  TraceOptions options;
  options.value_column = value;
  options.unit = unit;
  return options;
}

std::string content_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

TEST_CASE("A MAT-file gives vectors, columns and fields of structs") {
  const TemporaryFolder folder;
  const auto path = folder / "a.mat";
  const mat_ft version = GENERATE(MAT_FT_MAT5, MAT_FT_MAT73);
  CAPTURE(version);
  SECTION("column and row vectors") {
    {
      MatWriter file(path, version);
      file.write(MatWriter::matrix("time_s", hundredths_of_seconds(), samples));
      file.write(MatWriter::matrix("flow_L_s", waves(), 1));
    }
    check_waves(read_trace(path), 1e-3);
  }
  SECTION("a struct with a text for the unit") {
    {
      MatWriter file(path, version);
      file.write_struct("rec", {"time", "flow", "flow_units"},
                        {MatWriter::matrix(nullptr, hundredths_of_seconds(), samples),
                         MatWriter::matrix(nullptr, waves(), samples), MatWriter::text(nullptr, "L/min")});
    }
    const Trace trace = read_trace(path);
    check_waves(trace, 1e-3 / 60);
    CHECK_THAT(trace.notes.at(0), Contains("'time' names no unit of time: seconds are assumed"));
    CHECK_THAT(trace_error_at(path, picked("volume")),
               Contains("FILE: no variable 'volume' among 'time', 'flow'"));
  }
  SECTION("a rate instead of times") {
    {
      MatWriter file(path, version);
      file.write(MatWriter::matrix("Fs", {200.0}, 1));
      file.write(MatWriter::matrix("y", waves(), samples));
    }
    check_waves(read_trace(path, picked("y", "ml")), 1e-6, 200);
  }
  SECTION("an interval instead of times, names and units of the columns of a matrix") {
    {
      MatWriter file(path, version);
      auto both = waves(2);
      const auto flow = waves();
      both.insert(both.end(), flow.begin(), flow.end());
      file.write(MatWriter::matrix("data", both, samples));
      file.write(MatWriter::text("labels", "PFalwo w", 2));  // "Paw ", "Flow" column by column
      file.write(MatWriter::text("units", "cLm/Hs2 O ", 2));
      file.write(MatWriter::matrix("isi", {10.0}, 1));
      file.write(MatWriter::text("isi_units", "ms"));
    }
    check_waves(read_trace(path), 1e-3);
  }
  SECTION("a matrix whose rows are the signals") {
    {
      MatWriter file(path, version);
      std::vector<double> both;
      for (std::size_t i = 0; i < samples; ++i) {
        both.push_back(0.01 * static_cast<double>(i));
        both.push_back(wave(static_cast<int>(i)));
      }
      file.write(MatWriter::matrix("y", both, 2));
    }
    TraceOptions options = picked("y(2,:)", "L/s");
    options.time_column = "1";
    check_waves(read_trace(path, options), 1e-3);
  }
  SECTION("different lengths") {
    {
      MatWriter file(path, version);
      file.write(MatWriter::matrix("time_s", {0, 1, 2}, 3));
      file.write(MatWriter::matrix("flow_L_s", waves(), samples));
    }
    CHECK_THAT(trace_error_at(path),
               Contains("FILE: 400 values found in variable 'flow_L_s' and 3 in 'time_s'"));
  }
  SECTION("no vector") {
    MatWriter(path, version).write(MatWriter::matrix("x", {1.0}, 1));
    CHECK_THAT(trace_error_at(path), Contains("FILE: no vector of numbers found"));
  }
  SECTION("values that are not numbers") {
    auto values = waves();
    values[50] = NAN;
    {
      MatWriter file(path, version);
      file.write(MatWriter::matrix("fs", {100.0}, 1));
      file.write(MatWriter::matrix("volume_ml", values, samples));
    }
    CHECK_THAT(read_trace(path).notes.at(0), Contains("1 sample without a number interpolated: ") &&
                                                 Contains("sample 51: nan found in variable 'volume_ml'"));
  }
}

TEST_CASE("A MAT-file that is cut short is refused, since libmatio would fill it with zeros") {
  const TemporaryFolder folder;
  const auto path = folder / "a.mat";
  const bool compressed = GENERATE(true, false);
  {
    MatWriter file(path, MAT_FT_MAT5);
    file.write(MatWriter::matrix("fs", {100.0}, 1), compressed);
    file.write(MatWriter::matrix("volume_ml", waves(), samples), compressed);
  }
  const std::string whole = content_of(path);
  REQUIRE(trace_error_at(path).empty());
  for (const std::size_t kept : {whole.size() - 1, whole.size() / 2, std::size_t{200}, std::size_t{131}}) {
    folder.write("a.mat", whole.substr(0, kept));
    CAPTURE(kept);
    CHECK_THAT(trace_error_at(path), Contains("ends in the middle of a variable"));
  }
}

TEST_CASE("A damaged MAT-file gives an error of one line, even if libmatio crashes") {
  const TemporaryFolder folder;
  const auto path = folder / "a.mat";
  const mat_ft version = GENERATE(MAT_FT_MAT5, MAT_FT_MAT73);
  {
    MatWriter file(path, version);
    file.write(MatWriter::matrix("fs", {100.0}, 1), false);
    file.write_struct("rec", {"volume_ml"}, {MatWriter::matrix(nullptr, waves(), samples)});
    file.write(MatWriter::matrix("more", {1, 2, 3, 4}, 4), false);
  }
  const std::string good = content_of(path);
  REQUIRE(trace_error_at(path).empty());
  std::size_t refused = 0;
  for (std::size_t i = 0; i < 24; ++i) {
    std::string bad = good;
    const std::size_t place = (version == MAT_FT_MAT5 ? 128 : 512) + i * 37 % 400;  // the headers
    bad[place] = static_cast<char>(bad[place] ^ (i % 2 == 0 ? 0xFF : 0x08));
    folder.write("a.mat", i < 20 ? bad : good.substr(0, good.size() * (i - 19) / 5));
    refused += trace_error_at(path).empty() ? 0U : 1U;  // a crash would end the test
  }
  CHECK(refused > 4);
}

TEST_CASE("EDF and BDF give channels at their own rates") {
  const TemporaryFolder folder;
  const bool bdf = GENERATE(false, true);
  const auto path =
      folder.write("a.rec", edf_bytes({{"SpO2", "%", 1, 100, [](int) { return 98.0; }},
                                       {"Resp flow", "L/min", 100, 2, wave},
                                       {"Thorax", "a.u.", 25, 100, [](int i) { return 50 * wave(i); }}},
                                      4, bdf));
  const Trace flow = read_trace(path);
  CHECK(flow.kind == SignalKind::flow);
  CHECK(flow.value_unit == "L_min");
  check_waves(flow, 1e-3 / 60, 100, bdf ? 1e-6 : 1e-4);
  CHECK_THAT(flow.notes.at(0), Contains("channel 'Resp flow' as the flow"));

  TraceOptions belt = picked("Thorax");
  belt.kind = SignalKind::belt;
  const Trace thorax = read_trace(path, belt);
  REQUIRE(thorax.time_s.size() == 100);
  CHECK(thorax.time_s[99] == Approx(3.96));
  CHECK(thorax.value[99] == Approx(50 * wave(99)).margin(0.01));
  CHECK(thorax.value_unit == "a.u.");
  CHECK_THAT(trace_error_at(path, picked("SpO2")),
             Contains("'SpO2' does not end in a unit of volume or flow"));
  CHECK_THAT(trace_error_at(path, picked("4")),
             Contains("no channel '4' among 'SpO2', 'Resp flow', 'Thorax'"));
}

TEST_CASE("A damaged EDF file gives an error of one line") {
  const std::string good = edf_bytes({{"Flow", "L/s", 100, 2, wave}}, 4);
  REQUIRE(trace_error(good).empty());
  CHECK_THAT(trace_error(good.substr(0, good.size() - 1)),
             Contains("FILE: an EDF or BDF file that breaks the format"));
  CHECK_THAT(trace_error(good.substr(0, 300)), Contains("breaks the format or is cut short"));
  std::string bad = good;
  bad.replace(252, 4, "9999");  // channels
  CHECK_THAT(trace_error(bad), Contains("breaks the format"));
  bad = good;
  bad.replace(236, 8, "-1      ");  // records
  CHECK_THAT(trace_error(bad), Contains("breaks the format"));
}

TEST_CASE("Files of other known formats are named") {
  CHECK_THAT(trace_error("PK\x03\x04zip"), Contains("FILE: this is a spreadsheet (.xlsx"));
  CHECK_THAT(trace_error("\x89HDF\r\n"), Contains("binary file (HDF5") && Contains("expected text"));
  CHECK_THAT(trace_error("\x1F\x8Bgz"), Contains("gzip"));
  CHECK_THAT(trace_error("MATLAB 5.0 MAT-file" + std::string(120, ' ')),
             Contains("FILE: the MAT-file is damaged"));
}
