#include "breaths/mean_breath.hpp"
#include "support/breath_truth.hpp"
#include "support/catch.hpp"

using namespace trunk;
using namespace trunk::test;

namespace {

constexpr std::size_t breaths_each = 30;

// Which recordings a case makes: the first of them in the gate, all of them at night.
struct BreathStudy {
  std::vector<std::uint64_t> seeds;
  std::vector<Waveform> waveforms;
  std::vector<double> rates_hz;
};

const BreathStudy gate_study{{1}, {Waveform::recoil}, {100}};

BreathStudy night_study() {
  BreathStudy all{{}, {Waveform::recoil, Waveform::cosines}, {100, 250}};
  for (std::uint64_t seed = 2; seed < 12; ++seed) all.seeds.push_back(seed);
  return all;
}

// Returns the score over all recordings of a study. `change` gets 30 quiet breaths.
template <class Change>
BreathScore scored(const BreathStudy& study, Change change) {
  BreathScore score;
  for (const Waveform waveform : study.waveforms)
    for (const double rate_hz : study.rates_hz)
      for (const std::uint64_t seed : study.seeds) {
        Random random(100 + seed);
        TrueRecording r;
        r.breaths = varied_breaths(breaths_each, {}, random);
        r.waveform = waveform, r.rate_hz = rate_hz, r.seed = seed;
        change(r, random);
        score.add(r, segment_breaths(recording_trace(r)));
      }
  return score;
}

void check_all_found(const BreathScore& score) {
  CHECK(score.missing == std::vector<std::size_t>{});
  CHECK(score.invented == 0);
}

void check_onsets(const BreathScore& score, double most_ms = 25) {
  CAPTURE(score.onset_ms.mean(), score.onset_ms.deviation());
  CHECK(std::abs(score.onset_ms.mean()) < 25);
  CHECK(score.onset_ms.deviation() < most_ms);
}

void check_volumes(const BreathScore& score) {
  CAPTURE(score.volume_percent.mean(), score.volume_percent.deviation());
  CHECK(std::abs(score.volume_percent.mean()) < 1);
  CHECK(score.volume_percent.deviation() < 1.5);
}

void exercise_after_rest(TrueRecording& r, Random& random) {
  const auto fast = varied_breaths(breaths_each, {2000e-6, 0.8, 1.0, 0.1}, random);
  r.breaths.insert(r.breaths.end(), fast.begin(), fast.end());
  r.flow_noise = 10e-6;
}

void shallow_run(TrueRecording& r, Random& random) {
  for (std::size_t i = 10; i < 20; ++i) r.breaths[i].tidal_m3 = random.between(0.1, 0.2) * 500e-6;
}

void quick_shallow_run(TrueRecording& r, Random& random) {
  shallow_run(r, random);
  for (std::size_t i = 10; i < 20; ++i)
    r.breaths[i].inspiration_s = 0.6, r.breaths[i].expiration_s = 0.8, r.breaths[i].pause_s = 0;
}

void open_mask(TrueRecording& r, Random& random) {
  r.lead_s = r.tail_s = 60;
  r.mask_noise = random.between(5e-6, 100e-6);
}

// Breath by breath, the sum of white noise from onset to end is a bridge, whose deviation at the peak is
// sigma sqrt(dt Ti Te/T): nothing that sums a flow is more exact.
double least_deviation_percent(const TrueBreath& b, double flow_noise, double rate_hz) {
  const double out_s = b.duration_s() - b.inspiration_s;
  return 100 * flow_noise / b.tidal_m3 * std::sqrt(b.inspiration_s * out_s / b.duration_s() / rate_hz);
}

void check_noise(const BreathStudy& study) {
  const BreathScore score = scored(study, [](TrueRecording& r, Random&) { r.flow_noise = 100e-6; });
  check_all_found(score);
  const double rate_hz = study.rates_hz.front();
  // If all of the inspiration but its begin were known, 100 samples a second would still leave 19 ms.
  check_onsets(score, rate_hz > 100 ? 25 : 27);
  CAPTURE(score.volume_percent.mean(), score.volume_percent.deviation());
  CHECK(std::abs(score.volume_percent.mean()) < 1);
  CHECK(score.volume_percent.deviation() < 1.25 * least_deviation_percent({}, 100e-6, rate_hz));
}

void check_exactly_placed(const BreathScore& score) {
  check_all_found(score);
  check_onsets(score);
  check_volumes(score);
}

void check_small_breaths(const BreathStudy& study) {
  for (const auto change : {exercise_after_rest, shallow_run, quick_shallow_run, open_mask})
    check_all_found(scored(study, change));
}

void check_ripples(const BreathStudy& study) {
  check_exactly_placed(scored(study, [](TrueRecording& r, Random&) { r.heart_flow = 50e-6; }));
  check_exactly_placed(scored(study, [](TrueRecording& r, Random& random) {
    r.heart_volume = 10e-6, r.as_flow = false, r.heart_hz = random.between(1.0, 1.4);
  }));
}

// What wanders at the ends of a recording may cut its first and last breath.
BreathScore within(BreathScore score) {
  std::erase(score.missing, 0UL);
  std::erase(score.missing, breaths_each - 1);
  return score;
}

void check_wander(const BreathStudy& study) {
  check_exactly_placed(
      within(scored(study, [](TrueRecording& r, Random&) { r.wander_m3 = 100e-6, r.wander_s = 35; })));
  for (const auto& [litres, seconds] : {std::pair{0.2, 9.0}, {0.3, 12.0}}) {
    const BreathScore fast = within(scored(study, [&](TrueRecording& r, Random&) {
      r.wander_m3 = 1e-3 * litres, r.wander_s = seconds, r.as_flow = false;
    }));
    CHECK(fast.missing == std::vector<std::size_t>{});
    CHECK(fast.invented_kept == 0);
  }
}

}  // namespace

TEST_CASE("Small breaths are found beside large ones, and none beside an open mask", "[faults][breaths]") {
  check_small_breaths(gate_study);
}

TEST_CASE("Noise of a flow moves no onset by much", "[faults][breaths]") {
  check_noise(gate_study);
}

TEST_CASE("The heart moves no onset by much and no tidal volume", "[faults][breaths]") {
  check_ripples(gate_study);
}

TEST_CASE("A wandering base line merges no breaths", "[faults][breaths]") {
  check_wander(gate_study);
}

TEST_CASE("A peak is found to half a sample", "[faults][breaths]") {
  const double rate_hz = GENERATE(50.0, 250.0);
  const Waveform waveform = GENERATE(Waveform::recoil, Waveform::cosines);
  CAPTURE(rate_hz, static_cast<int>(waveform));
  const BreathScore score = scored({{1}, {waveform}, {rate_hz}}, [](TrueRecording&, Random&) {});
  CHECK(std::abs(score.peak_ms.mean()) < 500 / rate_hz);
  CHECK(score.peak_ms.deviation() < 500 / rate_hz);
}

TEST_CASE("Small breaths are found in many recordings", "[nightly][faults][breaths]") {
  check_small_breaths(night_study());
}

TEST_CASE("Noise moves no onset by much in many recordings", "[nightly][faults][breaths]") {
  BreathStudy study = night_study();
  study.rates_hz = {250};
  check_noise(study);
  study.rates_hz = {100}, study.waveforms = {Waveform::recoil};
  check_noise(study);
}

TEST_CASE("The heart moves no onset by much in many recordings", "[nightly][faults][breaths]") {
  check_ripples(night_study());
}

TEST_CASE("A wandering base line merges no breaths in many recordings", "[nightly][faults][breaths]") {
  check_wander(night_study());
}
