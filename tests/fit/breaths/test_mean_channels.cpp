#include <cmath>

#include "breaths/mean_breath.hpp"
#include "errors/input_error.hpp"
#include "support/catch.hpp"
#include "support/lung_breather.hpp"

using namespace trunk;
using namespace trunk::test;

namespace {

MeasuredBreath mean_of_trace(const Trace& trace) {
  return mean_breath(segment_breaths(trace));
}

double cmH2O(double Pa) {
  return Pa / Pa_per_cmH2O;
}

// Adds a swallow in the middle of the breath with this number, from 1.
void swallow(Trace& trace, const LungBreather& who, int number, double height_cmH2O) {
  const double middle = (number - 0.5) * who.period();
  change(trace.channels[0], trace.time_s, [&](double t, double v) {
    return v + Pa_per_cmH2O * height_cmH2O * std::exp(-0.5 * std::pow((t - middle) / 0.3, 2));
  });
}

}  // namespace

TEST_CASE("A channel follows the mean breath as the equation of the lung says", "[breaths]") {
  LungBreather who;
  who.drift = 0.3;  // a line that is removed
  const MeasuredBreath mean = mean_of_trace(recorded(who));
  const MeasuredChannel* pleural = mean.channel(ChannelKind::pleural);
  REQUIRE(pleural != nullptr);
  REQUIRE(mean.channel(ChannelKind::airway) == nullptr);
  REQUIRE(pleural->value.size() == mean.time_s.size());
  REQUIRE(pleural->each.size() == mean.used.size());
  CHECK(pleural->column == "poes");
  const double step = mean.time_s[1];
  for (std::size_t i = 1; i + 1 < mean.time_s.size(); ++i) {
    const double flow = litres_per_m3 * (mean.volume_m3[i + 1] - mean.volume_m3[i - 1]) / (2 * step);
    const double expected = -who.elastance * litres_per_m3 * mean.volume_m3[i] - who.resistance * flow;
    REQUIRE(cmH2O(pleural->value[i]) == Approx(expected).margin(0.1));
  }
  CHECK(cmH2O(pleural->end_expiratory) == Approx(-5 + who.drift * 16).margin(0.7));  // half the record
  double least = HUGE_VAL;
  for (const double sigma : pleural->sigma) least = std::min(least, sigma);
  CHECK(least > 0);
}

TEST_CASE("Each breath of a channel is there, and the mean is theirs", "[breaths]") {
  LungBreather who;
  who.noise = 0.5;
  const MeasuredBreath mean = mean_of_trace(recorded(who));
  const MeasuredChannel& gastric = *mean.channel(ChannelKind::gastric);
  const auto n = static_cast<double>(gastric.each.size());
  double squares = 0;
  for (std::size_t i = 0; i < gastric.value.size(); ++i) {
    double sum = 0;
    for (const auto& curve : gastric.each) sum += curve[i];
    REQUIRE(gastric.value[i] == Approx(sum / n).margin(1e-9));
    REQUIRE(gastric.standard_error[i] == Approx(gastric.sigma[i] / std::sqrt(n)));
    squares += gastric.sigma[i] * gastric.sigma[i];
  }
  // White noise, between samples a little less, and that of the two levels: 0.5 cmH2O within a fifth.
  CHECK(cmH2O(std::sqrt(squares / static_cast<double>(gastric.value.size()))) == Approx(0.5).epsilon(0.2));
}

TEST_CASE("A breath with a swallow does not count for the pressures that hold it", "[breaths]") {
  const LungBreather who;
  Trace trace = recorded(who);
  const MeasuredBreath clean = mean_of_trace(trace);
  swallow(trace, who, 3, 25);
  const MeasuredBreath mean = mean_of_trace(trace);
  const MeasuredChannel& pleural = *mean.channel(ChannelKind::pleural);
  CHECK(pleural.breaths == std::vector<std::size_t>{0, 1, 3, 4, 5, 6, 7});
  REQUIRE(pleural.notes.size() == 1);
  CHECK_THAT(pleural.notes[0], Contains("breath 3 does not count") && Contains("swallow"));
  CHECK(mean.channel(ChannelKind::gastric)->breaths.size() == 8);
  CHECK(mean.breaths_used == 8);
  for (std::size_t i = 0; i < mean.time_s.size(); ++i)
    REQUIRE(pleural.value[i] == Approx(clean.channel(ChannelKind::pleural)->value[i]).margin(3));
}

TEST_CASE("A deep breath is not taken for a swallow", "[breaths]") {
  const LungBreather who;
  Trace trace = recorded(who);
  const double from = 4 * who.period() + 0.5 * who.pause, until = from + who.period();
  const auto inside = [&](double t) { return t > from && t < until; };
  for (std::size_t i = 0; i < trace.time_s.size(); ++i)
    if (inside(trace.time_s[i])) trace.value[i] *= 1.8;
  change(trace.channels[0], trace.time_s,
         [&](double t, double v) { return inside(t) ? 1.8 * (v + 5 * Pa_per_cmH2O) - 5 * Pa_per_cmH2O : v; });
  CHECK(mean_of_trace(trace).channel(ChannelKind::pleural)->breaths.size() == 8);
}

TEST_CASE("A gap leaves out its breath, and a channel with gaps everywhere is refused", "[breaths]") {
  const LungBreather who;
  Trace trace = recorded(who);
  change(trace.channels[1], trace.time_s, [&](double t, double v) { return t > 9 && t < 9.5 ? NAN : v; });
  const MeasuredBreath mean = mean_of_trace(trace);
  CHECK(mean.channel(ChannelKind::gastric)->breaths == std::vector<std::size_t>{0, 1, 3, 4, 5, 6, 7});
  CHECK_THAT(mean.channel(ChannelKind::gastric)->notes.at(0), Contains("breath 3") && Contains("gap"));
  change(trace.channels[1], trace.time_s, [](double t, double v) { return std::fmod(t, 2) < 0.5 ? NAN : v; });
  CHECK_THROWS_WITH(mean_of_trace(trace), Contains("'pga'") && Contains("--pga none"));
}

TEST_CASE("The heart is found in pleural pressure, with its rate and its size", "[breaths]") {
  LungBreather who;
  who.heart = 1, who.breaths = 15;
  const MeasuredBreath mean = mean_of_trace(recorded(who));
  const MeasuredChannel& pleural = *mean.channel(ChannelKind::pleural);
  REQUIRE(pleural.notes.size() == 1);
  CHECK_THAT(pleural.notes[0], Contains("the heart") && Contains("7") && Contains("times a minute"));
  // 60 / 0.83 is 72; its standard deviation is 1 / sqrt(2), less what the mean and the average take.
  CHECK_THAT(pleural.notes[0], Contains("72 times") || Contains("71 times") || Contains("73 times"));
  CHECK_THAT(pleural.notes[0], Contains("0.6") || Contains("0.7"));
  who.heart = 0, who.noise = 0.5;
  CHECK(mean_of_trace(recorded(who)).channel(ChannelKind::pleural)->notes.empty());
}

TEST_CASE("A raw EMG becomes an envelope; an envelope stays", "[breaths]") {
  const LungBreather who;
  Trace trace = recorded(who);
  Random random(3);
  TraceChannel raw{ChannelKind::emg, "emg", "mV", {}}, smooth = raw;
  for (const double flow : trace.value) {
    const double activity = 0.05 + std::max(flow, 0.0) / 500e-6;  // about 1 at its peak
    raw.value.push_back(activity * random.normal());
    smooth.value.push_back(activity);
  }
  trace.channels = {raw};
  const MeasuredBreath found = mean_of_trace(trace);
  trace.channels = {smooth};
  const MeasuredBreath expected = mean_of_trace(trace);
  const MeasuredChannel &envelope = found.channels[0], &given = expected.channels[0];
  CHECK_THAT(envelope.notes.at(0), Contains("both signs"));
  CHECK(given.notes.empty());
  CHECK(*std::min_element(envelope.value.begin(), envelope.value.end()) == 0);
  double largest = *std::max_element(given.value.begin(), given.value.end());
  for (std::size_t i = 0; i < given.value.size(); ++i)  // the mean of |x| is 0.8 of the deviation
    REQUIRE(envelope.value[i] / std::sqrt(2 / std::numbers::pi) ==
            Approx(given.value[i]).margin(0.15 * largest));
}
