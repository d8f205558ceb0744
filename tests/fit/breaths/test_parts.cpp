#include "breaths/breath_sizes.hpp"
#include "breaths/mean_breath.hpp"
#include "support/breath_truth.hpp"
#include "support/catch.hpp"

using namespace trunk;
using namespace trunk::test;

namespace {

// 20 quiet breaths, then 15 in exercise.
TrueRecording rest_then_exercise() {
  Random random(3);
  TrueRecording r;
  r.breaths = varied_breaths(20, {}, random);
  const auto fast = varied_breaths(15, {2000e-6, 0.8, 1.0, 0.1}, random);
  r.breaths.insert(r.breaths.end(), fast.begin(), fast.end());
  return r;
}

double mean_size(const TrueRecording& r, std::size_t first, std::size_t end) {
  double sum = 0;
  for (std::size_t k = first; k < end; ++k) sum += r.breaths[k].tidal_m3 / static_cast<double>(end - first);
  return sum;
}

std::string joined_notes(const std::vector<std::string>& notes) {
  std::string text;
  for (const std::string& note : notes) text += note + "\n";
  return text;
}

BreathSelection time_window_of(std::optional<double> begin_s, std::optional<double> end_s) {
  BreathSelection selection;
  selection.begin_s = begin_s, selection.end_s = end_s;
  return selection;
}

}  // namespace

TEST_CASE("A recording with two sizes of breath is summarised over one, and says where both are",
          "[faults][breaths]") {
  const TrueRecording r = rest_then_exercise();
  const Segmentation found = segment_breaths(recording_trace(r));
  REQUIRE(found.breaths.size() == 35);
  for (std::size_t i = 0; i < 35; ++i) CHECK(found.breaths[i].kept == (i < 20));
  CHECK(mean_breath(found).tidal_volume_m3 == Approx(mean_size(r, 0, 20)).epsilon(0.01));
  CHECK_THAT(joined_notes(found.notes),
             Contains("the breaths have more than one size: ") && Contains("(breaths 1 to 20), ") &&
                 Contains("(breaths 21 to 35); only") && Contains("--begin and --end"));
}

TEST_CASE("Sizes of breath are parts of a recording, not single breaths", "[unit][breaths]") {
  const auto sized = [](std::vector<double> ml) {
    std::vector<Breath> breaths(ml.size());
    for (std::size_t i = 0; i < ml.size(); ++i) breaths[i].tidal_volume_m3 = 1e-6 * ml[i];
    return breaths;
  };
  CHECK(breath_sizes({}).empty());
  std::vector<double> sizes(30, 500);
  sizes[4] = 1500, sizes[11] = 1500, sizes[20] = 100;
  CHECK(breath_sizes(sized(sizes)).empty());
  for (std::size_t i = 12; i < 20; ++i) sizes[i] = 80;
  const auto parts = breath_sizes(sized(sizes));
  REQUIRE(parts.size() == 3);
  CHECK((parts[0].main && !parts[1].main && parts[2].main));
  CHECK(parts[1].tidal_volume_m3 == Approx(80e-6));
  CHECK(parts[2].last == 29);
}

TEST_CASE("A window holds breaths by their numbers in the whole recording", "[unit][breaths]") {
  const TrueRecording r = rest_then_exercise();
  const Trace trace = recording_trace(r);
  const double begin = r.onsets()[20] - 0.2, end = r.onsets()[30] + 0.2;
  const Segmentation all = segment_breaths(trace), part = segment_breaths(trace, time_window_of(begin, end));
  REQUIRE(part.breaths.size() == 10);
  REQUIRE(part.window);
  CHECK((part.window->first == 21 && part.window->last == 30 && part.window->breaths_recorded == 35));
  for (std::size_t i = 0; i < 10; ++i) {
    CHECK(part.breaths[i].number == 21 + i);
    CHECK(part.breaths[i].kept);
    CHECK(part.breaths[i].onset_s == Approx(all.breaths[20 + i].onset_s).margin(0.02));
    CHECK(part.breaths[i].tidal_volume_m3 == Approx(all.breaths[20 + i].tidal_volume_m3).epsilon(0.005));
  }
  CHECK_THAT(joined_notes(part.notes),
             Contains("is used: breaths 21 to 30 of 35") && !Contains("more than one size"));
  CHECK(part.time_s.size() == part.volume_m3.size());
  CHECK(part.time_s.front() > r.onsets()[18]);
  const MeasuredBreath mean = mean_breath(part);
  CHECK(mean.tidal_volume_m3 == Approx(mean_size(r, 20, 30)).epsilon(0.01));
  CHECK((mean.breaths_used == 10 && mean.breaths_rejected == 0));
  REQUIRE(mean.window);
  CHECK(mean.window->begin_s == begin);
  CHECK(single_breath(part, 25).tidal_volume_m3 == Approx(r.breaths[24].tidal_m3).epsilon(0.01));
  CHECK_THROWS_WITH(single_breath(part, 3), Contains("there is no breath 3; expected 21 to 30"));

  BreathSelection chosen = time_window_of(begin, std::nullopt);
  chosen.excluded = {24};
  const auto open = segment_breaths(trace, chosen).breaths;
  REQUIRE(open.size() == 15);
  CHECK_FALSE(open[3].kept);
  CHECK(open[3].reason == "excluded by --exclude");
  chosen.excluded = {2};
  CHECK_THROWS_WITH(segment_breaths(trace, chosen), Contains("--exclude names breath 2; expected 21 to 35"));
}

TEST_CASE("A window without a breath is refused", "[unit][breaths]") {
  const Trace trace = recording_trace(rest_then_exercise());
  CHECK_THROWS_WITH(segment_breaths(trace, time_window_of(30, 20)),
                    Contains("--begin 30: --end 20 comes before it; expected a later time"));
  CHECK_THROWS_WITH(segment_breaths(trace, time_window_of(10, 12)),
                    Contains("true.csv: no whole breath between --begin 10 s and --end 12 s") &&
                        Contains("which holds 35 breath(s)"));
  CHECK_THROWS_WITH(segment_breaths(trace, time_window_of(5000, std::nullopt)), Contains("no whole breath"));
}

TEST_CASE("Channels and deviations are cut with their volume", "[unit][breaths]") {
  Trace trace = recording_trace(rest_then_exercise());
  TraceChannel channel;
  channel.value = trace.time_s;
  trace.channels = {channel};
  trace.sigma_m3 = trace.time_s;
  const Segmentation part = segment_breaths(trace, time_window_of(20, 60));
  CHECK(part.channels[0].value == part.time_s);
  CHECK(part.sigma_m3 == part.time_s);
}

TEST_CASE("A base line bends with a slow wave and not at a step", "[unit][breaths]") {
  KnotLine wave, step;
  for (int i = 0; i < 12; ++i) {
    wave.time.push_back(4.0 * i), wave.value.push_back(std::sin(2 * std::numbers::pi * 4.0 * i / 20));
    step.time.push_back(4.0 * i), step.value.push_back(i < 6 ? 0 : 1);
  }
  double bent = 0, straight = 0;
  for (double t = 8; t < 36; t += 0.1) {
    const double truth = std::sin(2 * std::numbers::pi * t / 20);
    bent = std::max(bent, std::abs(wave(t) - truth));
    straight = std::max(straight, std::abs(interpolated(wave.time, wave.value, t) - truth));
    CHECK(step(t) == Approx(interpolated(step.time, step.value, t)).margin(1e-12));
  }
  CHECK(bent < 0.7 * straight);
}
