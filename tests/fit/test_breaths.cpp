#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "breaths/mean_breath.hpp"
#include "breaths/segment.hpp"
#include "errors/input_error.hpp"

using namespace trunk;
using Catch::Matchers::Contains;

namespace {

struct SyntheticShape {
  double tidal_volume_m3 = 500e-6, inspiration_s = 1.5, expiration_s = 2.0, pause_s = 0.5;
  double duration() const { return inspiration_s + expiration_s + pause_s; }
};

// Volume t after the onset of a breath: half a cosine up, half a cosine down, rest.
double volume_in(const SyntheticShape& breath, double t) {
  const double up = t / breath.inspiration_s, down = (t - breath.inspiration_s) / breath.expiration_s;
  const double phase = up < 1 ? up : std::max(1 - down, 0.0);
  return breath.tidal_volume_m3 * 0.5 * (1 - std::cos(std::numbers::pi * phase));
}

struct Record {
  std::vector<SyntheticShape> breaths = std::vector<SyntheticShape>(6);
  double rate_hz = 100;
  double skip_s = 0;      // cut from the start, inside the first breath
  double cut_s = 0;       // cut from the end, inside the last breath
  double noise_m3 = 0;    // white, on volume
  double drift_m3_s = 0;  // leak
};

std::vector<double> onsets_of(const Record& record) {
  std::vector<double> onsets{-record.skip_s};
  for (const auto& breath : record.breaths) onsets.push_back(onsets.back() + breath.duration());
  return onsets;
}

Trace volume_trace(const Record& record) {
  Trace trace;
  trace.source = "made.csv";
  const auto onsets = onsets_of(record);
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  std::size_t current = 0;
  for (int i = 0; i / record.rate_hz <= onsets.back() - record.cut_s + 1e-9; ++i) {
    const double t = i / record.rate_hz;
    while (current + 1 < record.breaths.size() && t >= onsets[current + 1]) ++current;
    trace.time_s.push_back(t);
    trace.value.push_back(volume_in(record.breaths[current], t - onsets[current]) + record.drift_m3_s * t +
                          record.noise_m3 * normal(random));
  }
  return trace;
}

Trace flow_trace(const Record& record, double offset_m3_s) {
  Trace trace = volume_trace(record);
  trace.kind = SignalKind::flow;
  trace.value_unit = "L_s";
  auto volume = trace.value;
  for (std::size_t i = 1; i + 1 < volume.size(); ++i)
    trace.value[i] = (volume[i + 1] - volume[i - 1]) * record.rate_hz / 2 + offset_m3_s;
  trace.value.front() = trace.value.back() = offset_m3_s;
  return trace;
}

// As ventilators show it: the volume starts from 0 at every onset.
Trace with_resets(Trace trace, const std::vector<double>& onsets) {
  double offset = 0;
  std::size_t next = 1;
  for (std::size_t i = 0; i < trace.value.size(); ++i) {
    if (next < onsets.size() && trace.time_s[i] >= onsets[next]) offset = trace.value[i], ++next;
    trace.value[i] -= offset;
  }
  return trace;
}

std::string error_of(const Trace& trace) {
  try {
    segment_breaths(trace);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

// Every breath of the record from `first` on is found, in place and size.
void check_found(const Segmentation& found, const Record& record, std::size_t first, std::size_t count,
                 double time_tolerance, double volume_tolerance) {
  const auto onsets = onsets_of(record);
  REQUIRE(found.breaths.size() == count);
  for (std::size_t i = 0; i < count; ++i) {
    CAPTURE(i);
    const Breath& breath = found.breaths[i];
    const SyntheticShape& shape = record.breaths[first + i];
    CHECK(breath.kept);
    CHECK(breath.reason.empty());
    CHECK(breath.onset_s == Approx(onsets[first + i]).margin(time_tolerance));
    CHECK(breath.peak_s == Approx(onsets[first + i] + shape.inspiration_s).margin(time_tolerance));
    CHECK(breath.tidal_volume_m3 == Approx(shape.tidal_volume_m3).epsilon(volume_tolerance));
    if (i > 0) CHECK(breath.onset_s == found.breaths[i - 1].end_s);
  }
}

}  // namespace

TEST_CASE("clean breaths are found at any sampling rate", "[unit][breaths]") {
  Record record;
  record.rate_hz = GENERATE(10.0, 50.0, 100.0, 500.0, 2000.0);
  CAPTURE(record.rate_hz);
  const Segmentation found = segment_breaths(volume_trace(record));
  check_found(found, record, 0, 6, std::max(0.03, 0.6 / record.rate_hz), 0.01);
  REQUIRE(found.volume_m3.size() == found.time_s.size());
  for (const auto& breath : found.breaths) {
    const auto at = static_cast<std::size_t>(std::lround(breath.onset_s * record.rate_hz));
    CHECK(std::abs(found.volume_m3[at]) < 5e-6);
  }
}

TEST_CASE("breaths of one record may differ; cut ones at its ends do not count", "[unit][breaths]") {
  Record record;
  record.breaths = {{}, {450e-6, 1.2, 2.0, 0.2}, {560e-6, 1.7, 2.2, 0.4}, {510e-6, 1.4, 1.9, 0.6}, {}};
  SECTION("cut in expiration and expiration") {
    record.skip_s = 2.0, record.cut_s = 1.5;
  }
  SECTION("cut in inspiration and inspiration") {
    record.skip_s = 0.8, record.cut_s = 3.2;
  }
  const Segmentation found = segment_breaths(volume_trace(record));
  check_found(found, record, 1, 3, 0.03, 0.01);
  REQUIRE_FALSE(found.notes.empty());
  CHECK_THAT(found.notes.back(), Contains("not used"));
}

TEST_CASE("a record of one whole breath is enough", "[unit][breaths]") {
  Record record;
  record.breaths.resize(1);
  record.rate_hz = 100;
  check_found(segment_breaths(volume_trace(record)), record, 0, 1, 0.03, 0.01);
  CHECK(segment_breaths(volume_trace(record)).breaths[0].end_s == Approx(4.0).margin(0.011));
}

TEST_CASE("noise moves breaths little and makes none", "[unit][breaths]") {
  Record record;
  record.breaths.resize(12);
  record.rate_hz = GENERATE(10.0, 100.0, 2000.0);
  record.noise_m3 = GENERATE(5e-6, 20e-6);  // 1 % and 4 % of the tidal volume
  CAPTURE(record.rate_hz, record.noise_m3);
  check_found(segment_breaths(volume_trace(record)), record, 0, 12, 0.25, 0.12);
}

TEST_CASE("a drift is removed, from a volume and from a flow's integral", "[unit][breaths]") {
  Record record;
  record.breaths.resize(8);
  const double drift = GENERATE(-60e-6, -20e-6, 20e-6, 60e-6);  // up to half a tidal volume a breath
  CAPTURE(drift);
  SECTION("volume") {
    record.drift_m3_s = drift;
    const Segmentation found = segment_breaths(volume_trace(record));
    check_found(found, record, 0, 8, 0.15, 0.02);
    CHECK_THAT(found.notes.at(0), Contains("drift of " + std::string(drift < 0 ? "-" : "")));
  }
  SECTION("flow") {
    const Segmentation found = segment_breaths(flow_trace(record, drift));
    check_found(found, record, 0, 8, 0.15, 0.02);
    CHECK(*std::max_element(found.volume_m3.begin(), found.volume_m3.end()) == Approx(500e-6).epsilon(0.02));
    CHECK(std::abs(*std::min_element(found.volume_m3.begin(), found.volume_m3.end())) < 25e-6);
  }
}

TEST_CASE("resets of the volume are undone", "[unit][breaths]") {
  Record record;
  record.breaths.resize(8);
  record.skip_s = 2.3;
  record.drift_m3_s = GENERATE(-30e-6, 15e-6);
  const Segmentation found = segment_breaths(with_resets(volume_trace(record), onsets_of(record)));
  check_found(found, record, 1, 7, 0.1, 0.02);
  CHECK_THAT(found.notes.at(0), Contains("reset"));
  // Continuous: no step larger than the breath itself makes in 10 ms.
  for (std::size_t i = 1; i < found.volume_m3.size(); ++i)
    REQUIRE(std::abs(found.volume_m3[i] - found.volume_m3[i - 1]) < 8e-6);
}

TEST_CASE("pauses belong to the breath before them, and plateaus have their peak in the middle",
          "[unit][breaths]") {
  Record record;
  record.breaths = std::vector<SyntheticShape>(6, SyntheticShape{500e-6, 1.0, 1.5, 2.5});
  record.noise_m3 = GENERATE(0.0, 4e-6);
  CAPTURE(record.noise_m3);
  check_found(segment_breaths(volume_trace(record)), record, 0, 6, 0.12, 0.03);

  Trace held = volume_trace(record);
  for (double& volume : held.value) volume = std::min(volume, 400e-6);
  const Segmentation found = segment_breaths(held);
  REQUIRE(found.breaths.size() == 6);
  // 0.8 of the height is passed 0.705 into the phase: from 0.705 s to 1 + 1.5 (1 - 0.705) = 1.4425 s.
  for (const auto& breath : found.breaths) CHECK(breath.peak_s - breath.onset_s == Approx(1.074).margin(0.1));
}

TEST_CASE("odd breaths are listed and rejected with a reason", "[unit][breaths]") {
  Record record;
  record.breaths.resize(9);
  SECTION("a sigh") {
    record.breaths[4].tidal_volume_m3 = 1400e-6;
    const auto breath = segment_breaths(volume_trace(record)).breaths.at(4);
    CHECK_FALSE(breath.kept);
    CHECK(breath.reason == "tidal volume 1400 ml is over twice the median 500 ml");
  }
  SECTION("a shallow breath") {
    record.breaths[4].tidal_volume_m3 = 210e-6;
    const auto breath = segment_breaths(volume_trace(record)).breaths.at(4);
    CHECK_FALSE(breath.kept);
    CHECK(breath.reason == "tidal volume 210 ml is under half the median 500 ml");
  }
  SECTION("an apnoea") {
    record.breaths[4].pause_s = 8;
    const auto breath = segment_breaths(volume_trace(record)).breaths.at(4);
    CHECK_FALSE(breath.kept);
    CHECK_THAT(breath.reason, Contains("duration 11.5 s is over twice the median 4 s"));
  }
  SECTION("a shift of the resting volume") {
    Trace trace = volume_trace(record);
    for (std::size_t i = 0; i < trace.value.size(); ++i)
      trace.value[i] += 330e-6 * std::clamp((trace.time_s[i] - 18) / 1.0, 0.0, 1.0);
    const auto breath = segment_breaths(trace).breaths.at(4);
    CHECK_FALSE(breath.kept);
    CHECK_THAT(breath.reason, Contains("above where it began"));
  }
  const Segmentation found = segment_breaths(volume_trace(record));
  REQUIRE(found.breaths.size() == 9);
  CHECK(std::count_if(found.breaths.begin(), found.breaths.end(), [](auto& b) { return b.kept; }) >= 8);
}

TEST_CASE("spikes of one sample are repaired, and said so", "[unit][breaths]") {
  Record record;
  Trace trace = volume_trace(record);
  trace.value[730] = 9e-3;
  trace.value[1510] = -4e-3;
  const Segmentation found = segment_breaths(trace);
  check_found(found, record, 0, 6, 0.03, 0.01);
  CHECK_THAT(found.notes.at(0), Contains("2 isolated spike(s)"));
}

TEST_CASE("what is no breathing", "[unit][breaths]") {
  Trace constant = volume_trace({});
  std::fill(constant.value.begin(), constant.value.end(), 300e-6);
  CHECK_THAT(error_of(constant), Contains("made.csv: all 2401 samples of the volume are 300 ml"));

  Record half;
  half.breaths.resize(1);
  half.cut_s = 2.4;
  CHECK_THAT(error_of(volume_trace(half)),
             Contains("made.csv: no whole breath in 1.6 s") && Contains("longer"));
  half.cut_s = 1.5;
  CHECK_THAT(error_of(volume_trace(half)), Contains("made.csv: no whole breath in 2.5 s"));
}

TEST_CASE("wrong units are told from what they make of the breaths", "[unit][breaths]") {
  const auto scaled = [](Trace trace, double time, double value, std::string time_unit,
                         std::string value_unit) {
    for (double& t : trace.time_s) t *= time;
    for (double& v : trace.value) v *= value;
    trace.time_unit = std::move(time_unit);
    trace.value_unit = std::move(value_unit);
    return trace;
  };
  const Trace volume = volume_trace({}), flow = flow_trace({}, 0);
  CHECK_THAT(error_of(scaled(volume, 1000, 1, "s", "ml")),
             Contains("made.csv: the breaths found last 4000 s") &&
                 Contains("may hold milliseconds: name it time_ms"));
  CHECK_THAT(error_of(scaled(volume, 1e-3, 1, "ms", "ml")),
             Contains("last 0.004 s") && Contains("may hold seconds: name it time_s"));
  CHECK_THAT(error_of(scaled(volume, 1, 1e-3, "s", "ml")),
             Contains("tidal volume of 0.5 ml") && Contains("may hold litres: name it volume_L"));
  CHECK_THAT(error_of(scaled(volume, 1, 1e3, "s", "L")), Contains("may hold millilitres: name it volume_ml"));
  CHECK_THAT(error_of(scaled(flow, 1, 60, "s", "L_s")),
             Contains("may hold litres per minute: name it flow_L_min"));
  CHECK_THAT(error_of(scaled(flow, 1, 1.0 / 60, "s", "L_min")), Contains("name it flow_L_s"));
  CHECK_THAT(error_of(scaled(flow, 1, 1e3, "s", "L_s")), Contains("name it flow_ml_s"));
  CHECK_THAT(error_of(scaled(volume, 1, 1e-9, "s", "ml")), Contains("check the unit"));
}

TEST_CASE("the mean breath keeps shape, timing and size", "[unit][breaths]") {
  Record record;
  record.breaths = {
      {}, {450e-6, 1.2, 2.0, 0}, {550e-6, 1.8, 2.4, 0}, {450e-6, 1.2, 2.0, 0}, {550e-6, 1.8, 2.4, 0}, {}};
  record.skip_s = 2.5, record.cut_s = 2.0;
  const Segmentation found = segment_breaths(volume_trace(record));
  REQUIRE(found.breaths.size() == 4);
  const MeasuredBreath mean = mean_breath(found, 101);
  REQUIRE(mean.time_s.size() == 101);
  CHECK(mean.breaths_used == 4);
  CHECK(mean.breaths_rejected == 0);
  CHECK(mean.inspiration_s == Approx(1.5).margin(0.02));
  CHECK(mean.duration_s == Approx(3.7).margin(0.02));
  CHECK(mean.tidal_volume_m3 == Approx(500e-6).epsilon(0.005));
  CHECK(mean.time_s.front() == 0);
  CHECK(mean.time_s.back() == mean.duration_s);
  CHECK(mean.time_s[50] == Approx(mean.duration_s / 2));
  CHECK(mean.volume_m3.front() == 0);
  CHECK(mean.volume_m3.back() == 0);
  const SyntheticShape shape{500e-6, 1.5, 2.2, 0};
  for (std::size_t i = 0; i < mean.time_s.size(); ++i)
    REQUIRE(mean.volume_m3[i] == Approx(volume_in(shape, mean.time_s[i])).margin(12e-6));
  // Depths of +-50 ml: a deviation of 57.7 ml at the peak; nothing but the floor of 1 % at the ends.
  CHECK(*std::max_element(mean.sigma_m3.begin(), mean.sigma_m3.end()) == Approx(57.7e-6).epsilon(0.03));
  CHECK(mean.sigma_m3.front() == Approx(5e-6).epsilon(0.01));
  CHECK(mean_breath(found).time_s.size() == 200);
}

TEST_CASE("rejected breaths are not averaged, but can be asked for", "[unit][breaths]") {
  Record record;
  record.breaths[2].tidal_volume_m3 = 1300e-6;
  const Segmentation found = segment_breaths(volume_trace(record));
  const MeasuredBreath mean = mean_breath(found);
  CHECK(mean.breaths_used == 5);
  CHECK(mean.breaths_rejected == 1);
  CHECK(mean.tidal_volume_m3 == Approx(500e-6).epsilon(0.01));
  const MeasuredBreath sigh = single_breath(found, 3);
  CHECK(sigh.breaths_used == 1);
  CHECK(sigh.tidal_volume_m3 == Approx(1300e-6).epsilon(0.01));
  CHECK(*std::max_element(sigh.volume_m3.begin(), sigh.volume_m3.end()) == Approx(1300e-6).epsilon(0.01));
  CHECK(sigh.volume_m3.back() == 0);
  CHECK_THROWS_WITH(single_breath(found, 0), Contains("made.csv: breath 0 asked for; expected 1 to 6"));
  CHECK_THROWS_WITH(single_breath(found, 7), Contains("made.csv: breath 7 asked for"));
  CHECK_THROWS_WITH(mean_breath(found, 2), Contains("made.csv: 2 samples"));
  Segmentation none = found;
  for (auto& breath : none.breaths) breath.kept = false;
  CHECK_THROWS_WITH(mean_breath(none), Contains("made.csv: no breath is kept"));
}

TEST_CASE("sigma of one breath is its noise, or what the trace says", "[unit][breaths]") {
  Record record;
  record.noise_m3 = 12e-6;
  Trace trace = volume_trace(record);
  CHECK(single_breath(segment_breaths(trace), 2).sigma_m3.at(77) == Approx(12e-6).epsilon(0.1));
  trace.sigma_m3.assign(trace.time_s.size(), 31e-6);
  CHECK(single_breath(segment_breaths(trace), 2).sigma_m3.at(77) == Approx(31e-6));
  CHECK(mean_breath(segment_breaths(trace)).sigma_m3.at(0) == Approx(31e-6));
}

namespace {

struct SegmentSummary {
  std::size_t found = 0, kept = 0;
  double tidal_volume_ml = 0, period_s = 0;
};

SegmentSummary summary_of(const Segmentation& segmentation) {
  const MeasuredBreath mean = mean_breath(segmentation);
  return {segmentation.breaths.size(), static_cast<std::size_t>(mean.breaths_used),
          mean.tidal_volume_m3 * 1e6, mean.duration_s};
}

}  // namespace

#ifdef TRUNK_SHARED_DATA
TEST_CASE("the breaths of real recordings are found, from flow and from volumes with resets",
          "[unit][breaths]") {
  const std::filesystem::path folder = std::filesystem::path(TRUNK_SHARED_DATA) / "traces";
  if (!std::filesystem::exists(folder / "cant_Subject01_0cmH2O_0mL.csv")) {
    WARN("skipped: no recordings in " << folder.string());
    return;
  }
  const auto summary = [&](const char* file, const char* column) {
    TraceOptions options;
    options.value_column = column;
    return summary_of(segment_breaths(read_trace(folder / file, options)));
  };
  const std::string column = GENERATE("", "volume_L", "volume_from_flow_L");
  CAPTURE(column);
  const SegmentSummary third = summary("cant_Subject03_0cmH2O_0mL.csv", column.c_str());
  CHECK(third.found == 10);
  CHECK(third.kept == 10);
  CHECK(third.tidal_volume_ml == Approx(1040).epsilon(0.04));
  CHECK(third.period_s == Approx(4.1).epsilon(0.02));
  const SegmentSummary first = summary("cant_Subject01_0cmH2O_0mL.csv", column.c_str());
  CHECK(first.found == 10);
  CHECK(first.kept == 10);
  CHECK(first.tidal_volume_ml == Approx(970).epsilon(0.04));
  CHECK(first.period_s == Approx(3.2).epsilon(0.02));
}
#endif

TEST_CASE("the constructed trace has its 8 breaths of 466 ml in the mean", "[unit][breaths]") {
  const auto file = std::filesystem::path(__FILE__).parent_path() / "../../reference/constructed_trace.csv";
  const SegmentSummary summary = summary_of(segment_breaths(read_trace(file)));
  CHECK(summary.found == 8);
  CHECK(summary.kept == 8);
  CHECK(summary.tidal_volume_ml == Approx(466).epsilon(0.01));
  CHECK(summary.period_s == Approx(5.0).epsilon(0.05));
}
