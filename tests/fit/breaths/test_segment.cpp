#include <ctime>

#include "support/breath_records.hpp"
#include "support/catch.hpp"

using namespace trunk;

namespace {

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
    CHECK(breath.peak_s == Approx(onsets[first + i] + shape.top_s()).margin(time_tolerance));
    CHECK(breath.tidal_volume_m3 == Approx(shape.tidal_volume_m3).epsilon(volume_tolerance));
    if (i > 0) CHECK(breath.onset_s == found.breaths[i - 1].end_s);
  }
}

}  // namespace

TEST_CASE("Clean breaths are found at any sampling rate", "[unit][breaths]") {
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

TEST_CASE("Breaths of one record may differ; cut ones at its ends do not count", "[unit][breaths]") {
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

TEST_CASE("A last expiration that the record cuts does not count as whole", "[unit][breaths]") {
  Record record;
  record.breaths.resize(6);
  record.cut_s = 0.9;  // of 2.5 s: nearly empty already, and no pause seen
  const Segmentation found = segment_breaths(volume_trace(record));
  REQUIRE(found.breaths.size() >= 5);
  for (std::size_t i = 0; i < 5; ++i) CHECK(found.breaths[i].kept);
  for (std::size_t i = 5; i < found.breaths.size(); ++i) {
    CHECK_FALSE(found.breaths[i].kept);
    CHECK_THAT(found.breaths[i].reason, Contains("the recording ends"));
  }
}

TEST_CASE("A record of one whole breath is enough", "[unit][breaths]") {
  Record record;
  record.breaths.resize(1);
  record.rate_hz = 100;
  check_found(segment_breaths(volume_trace(record)), record, 0, 1, 0.03, 0.01);
  CHECK(segment_breaths(volume_trace(record)).breaths[0].end_s == Approx(4.0).margin(0.011));
}

TEST_CASE("Noise moves breaths little and makes none", "[unit][breaths]") {
  Record record;
  record.breaths.resize(12);
  record.rate_hz = GENERATE(10.0, 100.0, 2000.0);
  record.noise_m3 = GENERATE(5e-6, 20e-6);  // 1 % and 4 % of the tidal volume
  CAPTURE(record.rate_hz, record.noise_m3);
  check_found(segment_breaths(volume_trace(record)), record, 0, 12, 0.25, 0.06);
}

TEST_CASE("A drift is removed, from a volume and from a flow's integral", "[unit][breaths]") {
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

TEST_CASE("The levels of rest are those before drift is removed, in the unit of the volume",
          "[unit][breaths]") {
  Record record;
  record.drift_m3_s = 20e-6;
  const Segmentation found = segment_breaths(volume_trace(record));
  REQUIRE(found.rest.time.size() == found.breaths.size() + 1);
  for (std::size_t i = 0; i < found.rest.time.size(); ++i)
    CHECK(found.rest.value[i] == Approx(20e-6 * found.rest.time[i]).margin(8e-6));
  BreathSelection scaled;
  scaled.calibrate_tidal_volume_m3 = 1000e-6;
  CHECK(segment_breaths(volume_trace(record), scaled).rest.value.back() ==
        Approx(2 * found.rest.value.back()).epsilon(0.02));
}

TEST_CASE("Resets of the volume are undone", "[unit][breaths]") {
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

TEST_CASE("Pauses belong to the breath before them, and plateaus have their peak in the middle",
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

TEST_CASE("Odd breaths are listed and rejected with a reason", "[unit][breaths]") {
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

TEST_CASE("Spikes of one sample are repaired, and a note says so", "[unit][breaths]") {
  Record record;
  Trace trace = volume_trace(record);
  trace.value[730] = 9e-3;
  trace.value[1510] = -4e-3;
  const Segmentation found = segment_breaths(trace);
  check_found(found, record, 0, 6, 0.03, 0.01);
  CHECK_THAT(found.notes.at(0), Contains("2 spike(s) replaced"));
}

TEST_CASE("Spikes of several samples, and close to each other, are repaired", "[unit][breaths]") {
  Record record;
  record.rate_hz = 500;
  Trace trace = volume_trace(record);
  for (std::size_t i = 0; i < 5; ++i) trace.value[3650 + i] = 9e-3, trace.value[7000 + i] -= 1e-3;
  trace.value[3657] = -2e-3;
  const Segmentation found = segment_breaths(trace);
  check_found(found, record, 0, 6, 0.03, 0.01);
  CHECK_THAT(found.notes.at(0), Contains("3 spike(s)"));
}

TEST_CASE("Onsets and sizes are not moved to one side by noise", "[unit][breaths]") {
  Record record;
  record.breaths =
      std::vector<SyntheticShape>(24, GENERATE(SyntheticShape{}, SyntheticShape{500e-6, 1.5, 2.0, 0},
                                               SyntheticShape{500e-6, 1.2, 2.0, 1.0, true}));
  record.noise_m3 = 4e-6;
  record.seed = GENERATE(1U, 2U, 3U);
  CAPTURE(record.breaths[0].pause_s, record.breaths[0].ventilated, record.seed);
  const Segmentation found = segment_breaths(volume_trace(record));
  const auto onsets = onsets_of(record);
  REQUIRE(found.breaths.size() == 24);
  double onset = 0, top = 0, volume = 0;
  for (std::size_t i = 0; i < 24; ++i) {
    const Breath& b = found.breaths[i];
    onset += (b.onset_s - onsets[i]) / 24;
    top += (b.peak_s - onsets[i] - record.breaths[i].top_s()) / 24;
    volume += (b.tidal_volume_m3 / 500e-6 - 1) / 24;
  }
  CHECK(std::abs(onset) < 0.02);
  CHECK(std::abs(top) < 0.02);
  CHECK(std::abs(volume) < 0.006);
}

TEST_CASE("Quick breaths without a pause are found at a low sampling rate", "[unit][breaths]") {
  Record record;
  record.breaths = std::vector<SyntheticShape>(20, SyntheticShape{300e-6, 0.73, 1.09, 0});
  record.rate_hz = GENERATE(15.0, 25.0, 100.0);
  CAPTURE(record.rate_hz);
  check_found(segment_breaths(flow_trace(record, 8e-6)), record, 0, 20, 0.06, 0.05);
}

TEST_CASE("Breaths of a ventilator are found although its flow drifts by litres", "[unit][breaths]") {
  Record record;
  record.breaths = std::vector<SyntheticShape>(40, SyntheticShape{500e-6, 1.4, 2.0, 1.5, true});
  record.rate_hz = 50;
  Trace trace = flow_trace(record, 0);
  for (double& flow : trace.value) flow = std::max(1.25 * flow, flow);  // a fifth of what goes in is lost
  const Segmentation found = segment_breaths(trace);
  REQUIRE(found.breaths.size() == 40);
  for (const Breath& b : found.breaths) {
    CHECK(b.kept);
    CHECK(b.inspired_m3 == Approx(625e-6).epsilon(0.02));
    CHECK(b.expired_m3 == Approx(500e-6).epsilon(0.02));
    CHECK(b.tidal_volume_m3 > b.expired_m3);
    CHECK(b.tidal_volume_m3 < b.inspired_m3);
    CHECK(b.pause_s == Approx(1.5).margin(0.7));
  }
  CHECK_THAT(found.notes.at(0), Contains("a drift of 125 ml a breath"));
}

TEST_CASE("A base line that wanders moves no breath", "[unit][breaths]") {
  Record record;
  record.breaths.resize(40);
  record.noise_m3 = 4e-6;
  Trace trace = volume_trace(record);
  SECTION("slowly up and down, by a tidal volume") {
    for (std::size_t i = 0; i < trace.value.size(); ++i)
      trace.value[i] += 250e-6 * std::sin(2 * std::numbers::pi * 0.02 * trace.time_s[i]);
  }
  SECTION("up and down by more than two tidal volumes, more slowly than anybody breathes") {
    for (std::size_t i = 0; i < trace.value.size(); ++i)
      trace.value[i] += 600e-6 * std::sin(2 * std::numbers::pi * trace.time_s[i] / 53);
  }
  SECTION("ever faster, by forty tidal volumes") {
    for (std::size_t i = 0; i < trace.value.size(); ++i)
      trace.value[i] += 20e-3 * std::pow(trace.time_s[i] / trace.time_s.back(), 2);
  }
  check_found(segment_breaths(trace), record, 0, 40, 0.2, 0.08);
}

TEST_CASE("Heart beats in the signal are not taken for breaths", "[unit][breaths]") {
  Record record;
  record.breaths.resize(12);
  Trace trace = volume_trace(record);
  for (std::size_t i = 0; i < trace.value.size(); ++i)
    trace.value[i] += 20e-6 * std::sin(2 * std::numbers::pi * 1.2 * trace.time_s[i]);
  check_found(segment_breaths(trace), record, 0, 12, 0.6, 0.1);
}

TEST_CASE("After an apnoea the next breath begins where it begins", "[unit][breaths]") {
  Record record;
  record.breaths = std::vector<SyntheticShape>(12, SyntheticShape{350e-6, 0.65, 0.85, 0});
  record.breaths[5].pause_s = 10;
  record.noise_m3 = 3e-6;
  const Segmentation found = segment_breaths(volume_trace(record));
  REQUIRE(found.breaths.size() == 12);
  CHECK_FALSE(found.breaths[5].kept);
  CHECK(found.breaths[6].kept);
  CHECK(found.breaths[6].onset_s == Approx(onsets_of(record)[6]).margin(0.04));
}

TEST_CASE("Resets at every third breath are undone in noise", "[unit][breaths]") {
  Record record;
  record.breaths.resize(12);
  record.drift_m3_s = -20e-6;
  record.noise_m3 = 4e-6;
  auto onsets = onsets_of(record);
  std::vector<double> third;
  for (std::size_t i = 0; i < onsets.size(); i += 3) third.push_back(onsets[i]);
  const Segmentation found = segment_breaths(with_resets(volume_trace(record), third));
  check_found(found, record, 0, 12, 0.25, 0.05);
}

TEST_CASE("A signal cut off at its top is noted with its share", "[unit][breaths]") {
  Trace trace = volume_trace({});
  for (double& v : trace.value) v = std::min(v, 425e-6);
  CHECK_THAT(
      segment_breaths(trace).notes.at(0),
      Contains("% of the samples lie at the highest value, 425 ml: the signal is clipped, or held there"));
  for (const auto& note : segment_breaths(volume_trace({})).notes) CHECK_THAT(note, !Contains("clipped"));
}

TEST_CASE("A rest or a top of ten minutes costs no more time and blurs no other turn", "[unit][breaths]") {
  Record record;
  record.breaths[3].pause_s = 600;
  Trace trace = volume_trace(record);
  const std::clock_t begin = std::clock();
  const auto found = segment_breaths(trace).breaths;
  for (double& v : trace.value) v = -v;
  CHECK(segment_breaths(trace).breaths.size() >= 4);
  CHECK((std::clock() - begin) / CLOCKS_PER_SEC < 20);  // of the processor; minutes, if squared
  REQUIRE(found.size() == 6);
  const auto onsets = onsets_of(record);
  for (std::size_t i = 0; i < 6; ++i) CHECK(found[i].onset_s == Approx(onsets[i]).margin(0.05));
}

TEST_CASE("A slow regular wander larger than the breaths is not taken for them", "[unit][breaths]") {
  Record record;
  record.breaths.resize(40);
  Trace trace = volume_trace(record);
  for (std::size_t i = 0; i < trace.value.size(); ++i)
    trace.value[i] += 1500e-6 * std::sin(2 * std::numbers::pi * trace.time_s[i] / 53);
  CHECK(segment_breaths(trace).breaths.size() == 40);
}

TEST_CASE("A signal that is not breathing is refused", "[unit][breaths]") {
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

TEST_CASE("Breaths of four samples are refused", "[unit][breaths]") {
  Record record;
  record.breaths.assign(30, {500e-6, 0.4, 0.6, 0});
  record.rate_hz = 4;
  CHECK_THAT(error_of(volume_trace(record)), Contains("made.csv: the median breath has 4 samples"));
  record.rate_hz = 10;
  CHECK(error_of(volume_trace(record)).empty());
}

TEST_CASE("A wrong unit is recognised from the breaths that it gives", "[unit][breaths]") {
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
             Contains("made.csv: the median breath lasts 3999 s; expected 0.8 to 30 s") &&
                 Contains("may hold milliseconds: name it time_ms"));
  CHECK_THAT(error_of(scaled(volume, 1e-3, 1, "ms", "ml")),
             Contains("lasts 0.004 s") && Contains("may hold seconds: name it time_s"));
  CHECK_THAT(error_of(scaled(volume, 1, 1e-3, "s", "ml")),
             Contains("tidal volume of 0.5 ml") && Contains("may hold litres: name it volume_L"));
  CHECK_THAT(error_of(scaled(volume, 1, 1e3, "s", "L")), Contains("may hold millilitres: name it volume_ml"));
  CHECK_THAT(error_of(scaled(flow, 1, 60, "s", "L_s")),
             Contains("may hold litres per minute: name it flow_L_min"));
  CHECK_THAT(error_of(scaled(flow, 1, 1.0 / 60, "s", "L_min")), Contains("name it flow_L_s"));
  CHECK_THAT(error_of(scaled(flow, 1, 1e3, "s", "L_s")), Contains("name it flow_ml_s"));
  CHECK_THAT(error_of(scaled(volume, 1, 1e-9, "s", "ml")), Contains("check the unit"));
}
