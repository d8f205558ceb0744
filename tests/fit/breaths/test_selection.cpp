#include <cmath>

#include "breaths/mean_breath.hpp"
#include "breaths/selection.hpp"
#include "breaths/turn_fit.hpp"
#include "support/breath_records.hpp"
#include "support/catch.hpp"

using namespace trunk;
using BreathNumbers = std::vector<std::size_t>;

TEST_CASE("Numbers of breaths are read, also as ranges", "[unit][breaths]") {
  CHECK(breath_numbers("--exclude", "3") == BreathNumbers{3});
  CHECK(breath_numbers("--exclude", "3,7,9-11") == BreathNumbers{3, 7, 9, 10, 11});
  CHECK(breath_numbers("--exclude", "4-4") == BreathNumbers{4});
  for (const char* bad : {"", "0", "-3", "3-", "5-3", "3,,4", "3,", "a", "3 4", "3;4", "1-2-3", "1.5",
                          "1000000", "99999999999999999999"}) {
    CAPTURE(bad);
    CHECK_THROWS_WITH(breath_numbers("--exclude", bad),
                      Contains("--exclude") && Contains("as in 3,7 or 3-5"));
  }
}

TEST_CASE("The user's choice of breaths overrules the program's", "[unit][breaths]") {
  Record record;
  record.breaths[2].tidal_volume_m3 = 1300e-6;
  const Trace trace = volume_trace(record);
  const auto chosen = segment_breaths(trace, {{1, 5}, {3}, {}}).breaths;
  REQUIRE(chosen.size() == 6);
  for (const std::size_t i : {0UL, 4UL}) {
    CHECK_FALSE(chosen[i].kept);
    CHECK(chosen[i].reason == "excluded by --exclude");
  }
  CHECK(chosen[2].kept);
  CHECK(chosen[2].reason ==
        "included by --include, though tidal volume 1300 ml is over twice the median 500 ml");
  CHECK(chosen[3].kept);
  CHECK(chosen[3].reason.empty());
  const auto sigh = segment_breaths(trace, {{3}, {}, {}}).breaths[2];  // the stronger reason stays
  CHECK_THAT(sigh.reason, Contains("tidal volume"));
  CHECK_THROWS_WITH(segment_breaths(trace, {{7}, {}, {}}),
                    Contains("made.csv: --exclude names breath 7; expected 1 to 6, the whole breaths found"));
  CHECK_THROWS_WITH(segment_breaths(trace, {{}, {9}, {}}), Contains("--include names breath 9"));
  CHECK_THROWS_WITH(segment_breaths(trace, {{2}, {2}, {}}), Contains("breath 2 is named by both"));
  CHECK_THROWS_WITH(mean_breath(segment_breaths(trace, {{1, 2, 4, 5, 6}, {}, {}})),
                    Contains("none of the 6 whole breaths"));
}

TEST_CASE("A belt has breaths in its own unit until it is calibrated", "[unit][breaths]") {
  Record record;
  record.breaths.resize(9);
  record.breaths[4].tidal_volume_m3 = 1400e-6;
  Trace trace = volume_trace(record);
  trace.kind = SignalKind::belt;
  for (double& v : trace.value) v = 2000 + 4e6 * v;  // a breath of 500 ml is 2000 units
  const Segmentation belt = segment_breaths(trace);
  CHECK_FALSE(belt.calibrated);
  CHECK(belt.breaths.size() == 9);
  CHECK(belt.breaths[0].tidal_volume_m3 == Approx(2000).epsilon(0.01));
  CHECK(belt.breaths[4].reason == "tidal volume 5600 a.u. is over twice the median 2000 a.u.");
  CHECK_THROWS_WITH(mean_breath(belt), Contains("made.csv:") && Contains("--calibrate-tidal-volume"));
  CHECK_THROWS_WITH(single_breath(belt, 1), Contains("--calibrate-tidal-volume"));

  const Segmentation litres = segment_breaths(trace, {{}, {}, 600e-6});
  CHECK(litres.calibrated);
  CHECK(mean_breath(litres).tidal_volume_m3 == Approx(600e-6).epsilon(0.01));
  CHECK(*std::max_element(litres.volume_m3.begin(), litres.volume_m3.end()) == Approx(1680e-6).epsilon(0.01));
  CHECK(litres.breaths[0].inspired_m3 == Approx(600e-6).epsilon(0.02));
  CHECK(litres.breaths[4].reason == "tidal volume 1680 ml is over twice the median 600 ml");
  CHECK_THAT(litres.notes.at(0), Contains("scaled so that the median tidal volume is 600 ml"));

  for (double& t : trace.time_s) t *= 1000;
  CHECK_THROWS_WITH(segment_breaths(trace), Contains("name it time_ms"));
}

TEST_CASE("A volume of wrong calibration is scaled, its deviations too", "[unit][breaths]") {
  Trace trace = volume_trace({});
  for (double& v : trace.value) v *= 1e-3;  // half a millilitre a breath: refused without
  trace.sigma_m3.assign(trace.value.size(), 31e-9);
  CHECK_THAT(error_of(trace), Contains("tidal volume of 0.5 ml"));
  const Segmentation scaled = segment_breaths(trace, {{}, {}, 500e-6});
  CHECK(mean_breath(scaled).tidal_volume_m3 == Approx(500e-6).epsilon(0.01));
  CHECK(mean_breath(scaled).sigma_m3.at(0) == Approx(31e-6).epsilon(0.01));
  CHECK_THAT(scaled.notes.at(0), Contains("is 500 ml, which was 0.5 ml"));
}

TEST_CASE("A planted turn is found again, whatever its shape", "[unit][breaths]") {
  const double before = GENERATE(0.0, HUGE_VAL), after = GENERATE(0.0, 0.2, HUGE_VAL),
               end = GENERATE(1.2, 1.8);
  CAPTURE(before, after, end);
  const std::size_t samples = GENERATE(60UL, 3000UL);  // the latter are thinned
  std::vector<double> time, volume;
  for (std::size_t i = 0; i < samples; ++i) {
    const double t = 3.0 * static_cast<double>(i) / static_cast<double>(samples);
    time.push_back(t);
    volume.push_back(7 + 2 * volume_from_turn(std::max(1.2 - t, 0.0), before) +
                     3 * volume_from_turn(std::max(t - end, 0.0), after));
  }
  const Turn turn = fit_turn(time, volume, {before, after}, {});
  CHECK(turn.begin_s == Approx(1.2).margin(0.01));
  CHECK(turn.end_s == Approx(end).margin(0.01));
  CHECK(turn.level == Approx(7).margin(0.02));
}

TEST_CASE("A turn is found although one of its sides is not in the record", "[unit][breaths]") {
  std::vector<double> time, volume;
  for (int i = 0; i < 50; ++i) {
    time.push_back(0.02 * i);
    volume.push_back(5 + std::pow(std::max(time.back() - 0.4, 0.0), 2) + (i % 2 == 0 ? 1e-3 : -1e-3));
  }
  const Turn turn = fit_turn(time, volume, {HUGE_VAL, HUGE_VAL}, {false, true});
  CHECK(turn.begin_s == 0);
  CHECK(turn.end_s == Approx(0.4).margin(0.03));
  CHECK(fit_turn(time, volume, {0, 0}, {false, false}).end_s == time.back());
}
