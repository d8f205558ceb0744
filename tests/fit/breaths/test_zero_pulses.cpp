#include "breaths/zero_pulses.hpp"
#include "support/breath_records.hpp"
#include "support/breath_truth.hpp"
#include "support/catch.hpp"

using namespace trunk;
using namespace trunk::test;

namespace {

// The flowmeter zeroes itself for 0.3 s every 3.1 s.
Trace with_pulses(Trace trace) {
  for (std::size_t i = 0; i < trace.value.size(); ++i)
    if (std::fmod(trace.time_s[i], 3.1) > 2.8) trace.value[i] = 0;
  return trace;
}

TrueRecording breaths_without_pause() {
  Random random(8);
  TrueRecording r;
  r.breaths = varied_breaths(20, {500e-6, 1.7, 2.0, 0}, random);
  return r;
}

}  // namespace

TEST_CASE("Pulses at zero flow are bridged and told", "[faults][breaths]") {
  const TrueRecording r = breaths_without_pause();
  const Trace whole = recording_trace(r), zeroed = with_pulses(whole);
  BreathScore score;
  const Segmentation found = segment_breaths(zeroed);
  score.add(r, found);
  CHECK(score.missing.empty());
  CHECK(score.invented == 0);
  CHECK(std::abs(score.volume_percent.mean()) < 0.5);
  CHECK(score.volume_percent.deviation() < 3);
  CHECK_THAT(found.notes.at(0), Contains("pulse(s) of 0.3 s at zero flow, the first at") &&
                                    Contains("the flow is bridged there"));

  // Without the bridge every pulse takes its part of a tidal volume.
  double taken = 0, inspired = 0;
  for (std::size_t i = 0; i < whole.value.size(); ++i) {
    inspired += std::max(whole.value[i], 0.0);
    if (zeroed.value[i] != whole.value[i]) taken += std::max(whole.value[i], 0.0);
  }
  CHECK(taken > 0.009 * inspired);
}

TEST_CASE("A cubic goes over a pulse as the flow does beside it", "[unit][breaths]") {
  std::vector<double> time, flow;
  for (int i = 0; i < 200; ++i) time.push_back(0.01 * i), flow.push_back(1 + std::pow(time.back(), 2));
  std::vector<double> broken = flow;
  for (std::size_t i = 90; i < 110; ++i) broken[i] = 0;
  const auto pulses = zero_pulses(time, broken);
  REQUIRE(pulses.size() == 1);
  CHECK((pulses[0].first == 90 && pulses[0].last == 109));
  bridge(time, pulses, broken);
  for (std::size_t i = 90; i < 110; ++i) CHECK(broken[i] == Approx(flow[i]).margin(0.005));
}

TEST_CASE("Pauses, held breaths, noise and a lone drop-out are no pulses", "[unit][breaths]") {
  const auto pulses_of = [](const Trace& trace) { return zero_pulses(trace.time_s, trace.value).size(); };
  TrueRecording r = breaths_without_pause();
  CHECK(pulses_of(recording_trace(r)) == 0);
  for (TrueBreath& b : r.breaths) b.pause_s = 0.6;
  CHECK(pulses_of(recording_trace(r)) == 0);
  r.flow_noise = 100e-6;
  CHECK(pulses_of(recording_trace(r)) == 0);
  Record held;
  held.breaths.assign(20, SyntheticShape{500e-6, 1.4, 2.0, 0.8, true});
  CHECK(pulses_of(flow_trace(held, 0)) == 0);
  Trace lone = recording_trace(breaths_without_pause());
  const auto at = static_cast<std::size_t>(100 * (breaths_without_pause().onsets()[4] + 0.8));
  for (std::size_t i = at; i < at + 5; ++i) lone.value[i] = 0;
  CHECK(pulses_of(lone) == 0);
}

TEST_CASE("One spike is repaired and is no limit of the signal", "[faults][breaths]") {
  Trace trace = recording_trace(breaths_without_pause());
  trace.value[1200] = 0.1;  // 100 L/s
  const Segmentation found = segment_breaths(trace);
  CHECK(found.breaths.size() == 20);
  std::string notes;
  for (const std::string& note : found.notes) notes += note;
  CHECK_THAT(notes, Contains("1 spike(s)") && !Contains("clipped"));
}

TEST_CASE("What noise makes of a flow is no spike", "[unit][breaths]") {
  TrueRecording r = breaths_without_pause();
  r.flow_noise = 100e-6;
  for (const std::string& note : segment_breaths(recording_trace(r)).notes)
    CHECK_THAT(note, !Contains("spike"));
}
