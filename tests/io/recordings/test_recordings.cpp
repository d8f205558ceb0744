#include <matio.h>

#include <cmath>
#include <cstring>
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
  SECTION("a block, which no MAT-file has") {
    MatWriter(path, version).write(MatWriter::matrix("x", {1.0}, 1));
    TraceOptions options;
    options.block = 2;
    CHECK_THROWS_WITH(read_trace(path, options), StartsWith("--block 2: ") && Contains("has 1 block;"));
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

TEST_CASE("A MAT-file of LabChart gives its channels and blocks", "[faults]") {
  const TemporaryFolder folder;
  const auto path = folder / "a.mat";
  const mat_ft version = GENERATE(MAT_FT_MAT5, MAT_FT_MAT73);
  const auto write = [&](double rate) {
    std::vector<double> data(100, 7.0);  // the first block: 50 samples of each channel
    const auto flow = waves(), pressure = waves(2);
    data.insert(data.end(), pressure.begin(), pressure.end());
    data.insert(data.end(), flow.begin(), flow.end());
    MatWriter file(path, version);
    file.write(MatWriter::matrix("data", data, 1));
    file.write(MatWriter::matrix("datastart", {1, 51, 101, 501}, 2));  // [channels][blocks]
    file.write(MatWriter::matrix("dataend", {50, 100, 500, 900}, 2));
    file.write(MatWriter::matrix("samplerate", {100, 100, rate, rate}, 2));
    file.write(MatWriter::text("titles", "PFmloouw", 2));  // "Pmou", "Flow"
    file.write(MatWriter::text("unittext", "cLm/Hs2 O ", 2));
    file.write(MatWriter::matrix("unittextmap", {1, 2, 1, 2}, 2));
  };
  write(100);
  const Trace trace = read_trace(path);
  check_waves(trace, 1e-3);
  CHECK_THAT(trace.notes.at(trace.notes.size() - 1),
             Contains("the file has 2 blocks: block 2, the longest, is read, of 4 s (--block 1 "));
  TraceOptions first;
  first.block = 1;
  CHECK(read_trace(path, first).value == std::vector<double>(50, 7e-3));
  first.block = 3;
  CHECK_THROWS_WITH(read_trace(path, first), StartsWith("--block 3: ") && Contains("has 2 blocks"));
  write(1e9);  // then the first block is longer
  CHECK(read_trace(path).value.size() == 50);
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

TEST_CASE("EDF+D is read where its records follow each other", "[faults]") {
  const bool bdf = GENERATE(false, true);
  const std::vector<EdfChannel> channels{{"Flow.40ms", "L/s", 100, 2, wave},
                                         {"Press", "cmH2O", 25, 50, wave}};
  const auto file = [&](const std::vector<std::string>& starts) {
    return edf_bytes(channels, static_cast<int>(starts.size()), bdf, starts);
  };
  const double accuracy = bdf ? 1e-6 : 1e-4;
  check_waves(trace_of(file({"+0", "+1", "+2", "+3"})), 1e-3, 100, accuracy);
  check_waves(trace_of(file({"+0.25", "+1.25", "+2.25", "+3.25"})), 1e-3, 100, accuracy);

  const std::string interrupted = file({"+0", "+1", "+7.5", "+8.5", "+9.5"});
  const Trace longest = trace_of(interrupted);
  REQUIRE(longest.value.size() == 300);
  for (int i = 0; i < 300; ++i) REQUIRE(longest.value[i] == Approx(1e-3 * wave(200 + i)).margin(2e-7));
  CHECK_THAT(longest.notes.at(1),
             Contains("part 2 of 2, the longest, is read, 3 s from 7.5 s on (--block 1 reads another)"));
  TraceOptions first;
  first.block = 1;
  const Trace earlier = trace_of(interrupted, first);
  REQUIRE(earlier.value.size() == 200);
  CHECK(earlier.value[150] == Approx(1e-3 * wave(150)).margin(2e-7));
  first.block = 3;
  CHECK_THROWS_WITH(trace_of(interrupted, first),
                    Contains("--block 3: ") && Contains("has 2 uninterrupted parts"));

  CHECK_THAT(trace_error(interrupted.substr(0, interrupted.size() - 1)), Contains("cut short"));
  CHECK_THAT(trace_error(file({"+0", "+1", "nothing"})), Contains("record 3 has no time"));
}

TEST_CASE("A compressed variable that zlib finds changed is refused", "[faults]") {
  const TemporaryFolder folder;
  const auto path = folder / "a.mat";
  {
    MatWriter file(path, MAT_FT_MAT5);
    file.write(MatWriter::matrix("fs", {100.0}, 1));
    file.write(MatWriter::matrix("volume_ml", waves(100), samples));
  }
  const std::string good = content_of(path);
  REQUIRE(trace_error_at(path).empty());
  int other_numbers = 0, refused = 0;
  const Trace right = read_trace(path);
  for (std::size_t place = 240; place + 8 < good.size(); place += good.size() / 40) {
    std::string bad = good;
    bad[place] = static_cast<char>(bad[place] ^ 1);
    folder.write("a.mat", bad);
    const bool read = trace_error_at(path).empty();
    refused += read ? 0 : 1;
    other_numbers += read && read_trace(path).value != right.value ? 1 : 0;
  }
  CHECK(refused > 30);
  CHECK(other_numbers == 0);
}

namespace {

/// A data element of a MAT-file of version 5: its type and its content.
std::string mat_element(std::uint32_t type, std::string content) {
  const auto size = static_cast<std::uint32_t>(content.size());
  std::string bytes(2 * sizeof type, '\0');
  std::memcpy(bytes.data(), &type, sizeof type);
  std::memcpy(bytes.data() + sizeof type, &size, sizeof size);
  content.resize((content.size() + 7) / 8 * 8, '\0');
  return bytes + content;
}

std::string mat_words(const std::vector<std::uint32_t>& words) {
  return {reinterpret_cast<const char*>(words.data()), words.size() * sizeof(std::uint32_t)};
}

/// A table as MATLAB saves it: an object that refers to the bytes behind all variables, which have no name.
std::string mat_table(const std::string& name) {
  constexpr std::uint32_t int8 = 1, uint8 = 2, int32 = 5, uint32 = 6, matrix = 14;
  constexpr std::uint32_t of_uint8 = 9, of_uint32 = 13, opaque = 17;
  const auto array = [&](std::uint32_t of, std::uint32_t count, std::uint32_t type, const std::string& data) {
    return mat_element(matrix, mat_element(uint32, mat_words({of, 0})) +
                                   mat_element(int32, mat_words({1, count})) + mat_element(int8, "") +
                                   mat_element(type, data));
  };
  std::string bytes(2000, '\0');
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>(i);
  return mat_element(matrix, mat_element(uint32, mat_words({opaque, 0})) + mat_element(int8, name) +
                                 mat_element(int8, "MCOS") + mat_element(int8, "table") +
                                 array(of_uint32, 6, uint32, mat_words({0xDD000000, 2, 1, 1, 1, 1}))) +
         array(of_uint8, 2000, uint8, bytes);
}

}  // namespace

TEST_CASE("A MATLAB table is named, and its bytes are no signal", "[faults]") {
  const TemporaryFolder folder;
  const auto path = folder / "a.mat";
  const bool beside_vectors = GENERATE(false, true);
  {
    MatWriter file(path, MAT_FT_MAT5);
    file.write(MatWriter::matrix("fs", {100.0}, 1));
    if (beside_vectors) file.write(MatWriter::matrix("flow_L_s", waves(), samples));
  }
  folder.write("a.mat", content_of(path) + mat_table("T"));
  if (beside_vectors) {
    check_waves(read_trace(path), 1e-3);
    CHECK_THAT(trace_error_at(path, picked("T")),
               Contains("no variable 'T' among 'flow_L_s'") && Contains("writetable"));
  } else {
    CHECK_THAT(trace_error_at(path),
               Contains("FILE: a MATLAB table, timetable") && Contains("writetable(T, "));
    CHECK_THAT(trace_error_at(path, picked("1")), Contains("FILE: a MATLAB table"));
  }
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
  CHECK_THAT(trace_error("\r\n  <html><table>"), Contains("web page") && Contains("save the sheet as CSV"));
  CHECK_THAT(trace_error("{\"flow\": [1, 2]}"), Contains("this is JSON"));
  CHECK_THAT(trace_error("TDSm" + std::string(90, '\0')), Contains("LabVIEW"));
  const TemporaryFolder folder;
  CHECK_THAT(trace_error_at(folder.write("rest.ACQ", "\x1\x2" + std::string(90, '\0'))),
             Contains("binary file of AcqKnowledge; expected text, MATLAB, EDF or BDF; save it from"));
  CHECK_THAT(trace_error("MATLAB 5.0 MAT-file" + std::string(120, ' ')),
             Contains("FILE: the MAT-file is damaged"));
}
