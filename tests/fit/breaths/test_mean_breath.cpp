#include <filesystem>

#include "breaths/mean_breath.hpp"
#include "support/breath_records.hpp"
#include "support/catch.hpp"
#include "support/shared_data.hpp"
#include "traces/read_trace.hpp"

using namespace trunk;

TEST_CASE("The mean breath keeps shape, timing and size", "[unit][breaths]") {
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

TEST_CASE("Each breath that is averaged is there, stretched as the mean is", "[unit][breaths]") {
  Record record;
  record.breaths = {{450e-6, 1.2, 2.0, 0}, {550e-6, 1.8, 2.4, 0}, {1300e-6, 1.5, 2.2, 0},
                    {450e-6, 1.2, 2.0, 0}, {550e-6, 1.8, 2.4, 0}, {450e-6, 1.2, 2.0, 0}};
  const Segmentation found = segment_breaths(volume_trace(record));
  const MeasuredBreath mean = mean_breath(found, 101);
  REQUIRE(mean.each_m3.size() == 5);
  REQUIRE(mean.used.size() == 5);
  for (std::size_t b = 0; b < 5; ++b) {
    const SyntheticShape& shape = record.breaths[b < 2 ? b : b + 1];
    CHECK(mean.used[b].tidal_volume_m3 == Approx(shape.tidal_volume_m3).epsilon(0.01));
    REQUIRE(mean.each_m3[b].size() == 101);
    CHECK(mean.each_m3[b].front() == 0);
    CHECK(mean.each_m3[b].back() == 0);
    const SyntheticShape stretched{shape.tidal_volume_m3, mean.inspiration_s,
                                   mean.duration_s - mean.inspiration_s, 0};
    for (std::size_t i = 0; i < 101; ++i)
      REQUIRE(mean.each_m3[b][i] == Approx(volume_in(stretched, mean.time_s[i])).margin(15e-6));
  }
  for (std::size_t i = 0; i < 101; ++i) {
    double sum = 0;
    for (const auto& volume : mean.each_m3) sum += volume[i];
    REQUIRE(mean.volume_m3[i] == Approx(sum / 5).margin(1e-12));
  }
  const MeasuredBreath sigh = single_breath(found, 3);
  REQUIRE(sigh.each_m3.size() == 1);
  CHECK(sigh.each_m3.front() == sigh.volume_m3);
}

TEST_CASE("Rejected breaths are not averaged, but can be asked for", "[unit][breaths]") {
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
  CHECK_THROWS_WITH(single_breath(found, 0), Contains("made.csv: there is no breath 0; expected 1 to 6"));
  CHECK_THROWS_WITH(single_breath(found, 7), Contains("made.csv: there is no breath 7"));
  CHECK_THROWS_WITH(mean_breath(found, 2), Contains("made.csv: 2 samples"));
  Segmentation none = found;
  for (auto& breath : none.breaths) breath.kept = false, breath.reason = "it is odd";
  CHECK_THROWS_WITH(mean_breath(none),
                    Contains("made.csv: none of the 6 whole breaths can be used, the first "
                             "because it is odd") &&
                        Contains("--include"));
}

TEST_CASE("Sigma of one breath is its noise, or the sigma of the trace", "[unit][breaths]") {
  Record record;
  record.noise_m3 = 12e-6;
  Trace trace = volume_trace(record);
  CHECK(single_breath(segment_breaths(trace), 2).sigma_m3.at(77) == Approx(12e-6).epsilon(0.1));
  trace.sigma_m3.assign(trace.time_s.size(), 31e-6);
  CHECK(single_breath(segment_breaths(trace), 2).sigma_m3.at(77) == Approx(31e-6));
  const MeasuredBreath mean = mean_breath(segment_breaths(trace));
  CHECK(mean.sigma_m3.at(0) == Approx(31e-6));
  REQUIRE(mean.standard_error_m3.size() == mean.sigma_m3.size());
  CHECK(mean.standard_error_m3.at(77) == Approx(mean.sigma_m3[77] / std::sqrt(6.0)));
  CHECK(mean.pause_s == Approx(0.5).margin(0.25));
}

TEST_CASE("The mean of noisy breaths is the breath without noise", "[unit][breaths]") {
  Record record;
  record.breaths.resize(30);
  record.noise_m3 = 4e-6;
  record.seed = GENERATE(1U, 2U, 3U);
  CAPTURE(record.seed);
  const MeasuredBreath mean = mean_breath(segment_breaths(volume_trace(record)));
  CHECK(mean.breaths_used == 30);
  CHECK(mean.duration_s == Approx(4.0).margin(0.01));
  CHECK(mean.inspiration_s == Approx(1.5).margin(0.03));
  for (std::size_t i = 0; i < mean.time_s.size(); ++i)
    REQUIRE(mean.volume_m3[i] == Approx(volume_in({}, mean.time_s[i])).margin(9e-6));
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

TEST_CASE("The breaths of real recordings are found, from flow and from volumes with resets",
          "[shared][breaths]") {
  const auto summary = [&](const char* file, const char* column) {
    TraceOptions options;
    options.value_column = column;
    return summary_of(segment_breaths(read_trace(test::shared_file(std::string("traces/") + file), options)));
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

TEST_CASE("The constructed trace has its 8 breaths of 466 ml in the mean", "[unit][breaths]") {
  const auto file = std::filesystem::path(TRUNK_SOURCE_DIR) / "reference/constructed_trace.csv";
  const SegmentSummary summary = summary_of(segment_breaths(read_trace(file)));
  CHECK(summary.found == 8);
  CHECK(summary.kept == 8);
  CHECK(summary.tidal_volume_ml == Approx(466).epsilon(0.01));
  CHECK(summary.period_s == Approx(5.0).epsilon(0.05));
}
