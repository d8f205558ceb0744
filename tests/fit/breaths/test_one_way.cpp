#include <functional>
#include <numbers>

#include "breaths/segment.hpp"
#include "support/breath_records.hpp"
#include "support/catch.hpp"

using namespace trunk;

namespace {

Record fourteen() {
  Record record;
  record.breaths.resize(14);
  for (std::size_t i = 0; i < record.breaths.size(); ++i)
    record.breaths[i].tidal_volume_m3 *= 1 + 0.05 * std::sin(3.0 * static_cast<double>(i));
  return record;
}

Trace changed(Trace trace, const std::function<double(double value, double time_s)>& change) {
  for (std::size_t i = 0; i < trace.value.size(); ++i)
    trace.value[i] = change(trace.value[i], trace.time_s[i]);
  return trace;
}

// Counts what is inspired, or expired if sign is -1.
Trace counted(const Trace& plain, double sign = 1) {
  Trace trace = plain;
  for (std::size_t i = 1; i < trace.value.size(); ++i)
    trace.value[i] = trace.value[i - 1] + std::max(sign * (plain.value[i] - plain.value[i - 1]), 0.0);
  return trace;
}

std::string notes_of(const Trace& trace) {
  std::string all;
  for (const std::string& note : segment_breaths(trace).notes) all += note + "\n";
  return all;
}

double tidal_ml(const Trace& trace) {
  double sum = 0;
  const Segmentation s = segment_breaths(trace);
  for (const Breath& b : s.breaths) sum += b.tidal_volume_m3;
  return 1e6 * sum / static_cast<double>(s.breaths.size());
}

}  // namespace

TEST_CASE("A flow without its sign, of one direction or with a large offset is refused", "[faults]") {
  Record record = fourteen();
  record.noise_m3 = GENERATE(0.0, 0.2e-6);  // 0.014 L/s of noise in the flow
  const Trace flow = flow_trace(record, 0);
  CHECK(error_of(flow).empty());
  const std::string without_sign = error_of(changed(flow, [](double q, double) { return std::abs(q); }));
  CHECK_THAT(without_sign, Contains("what is expired adds up to") && Contains("as if its sign were lost") &&
                               Contains("positive on inspiration and negative on expiration"));
  for (const double sign : {1.0, -1.0}) {
    const std::string one =
        error_of(changed(flow, [&](double q, double) { return std::max(sign * q, 0.0); }));
    CHECK_THAT(one, Contains("the flow goes one way"));
    if (record.noise_m3 == 0) CHECK_THAT(one, Contains("as if only one direction were recorded"));
  }
  CHECK_THAT(error_of(changed(flow, [](double q, double) { return -std::abs(q); })),
             Contains("what is inspired adds up to 0 % of what is expired"));
  Trace offset = changed(flow, [](double q, double) { return q + 1.5e-3; });
  CHECK_THAT(error_of(offset), Contains("shifted away from zero, as with an offset of the sensor") &&
                                   Contains("--remove-drift takes it away"));
  CHECK_THAT(error_of(changed(flow, [](double q, double) { return q + 0.25e-3; })),
             Contains("shifted away from zero"));
  offset.drift_by_user = true;
  CHECK_THAT(notes_of(offset), Contains("--remove-drift takes away a drift as large as a breath"));
  CHECK(tidal_ml(offset) == Approx(tidal_ml(flow)).epsilon(0.01));
  CHECK(error_of(changed(flow, [](double q, double) { return q + 0.03e-3; })).empty());
}

TEST_CASE("A counter and a drift as large as a breath are refused", "[faults]") {
  Record record = fourteen();
  record.noise_m3 = GENERATE(0.0, 3e-6);
  const Trace volume = volume_trace(record);
  record.noise_m3 = 0;
  const Trace clean = volume_trace(record);
  const auto noisy = [&](Trace trace) {
    for (std::size_t i = 0; i < trace.value.size(); ++i) trace.value[i] += volume.value[i] - clean.value[i];
    return trace;
  };
  CHECK(error_of(volume).empty());
  const auto onsets = onsets_of(record);
  for (const Trace& counter :
       {counted(clean), counted(clean, -1), with_resets(counted(clean), {0, onsets[4], onsets[9]}),
        with_resets(counted(clean), onsets), changed(counted(clean), [](double v, double) { return -v; })})
    CHECK_THAT(error_of(noisy(counter)), Contains("hardly comes back") &&
                                             Contains("as a counter of one direction does") &&
                                             Contains("export the flow"));
  Trace drifting = changed(volume, [](double v, double t) { return v + 160e-6 * t; });
  CHECK_THAT(error_of(drifting), Contains("the volume rises and hardly comes back") &&
                                     Contains("drifts by the size of a breath"));
  CHECK_THAT(error_of(changed(volume, [](double v, double t) { return v - 160e-6 * t; })),
             Contains("the volume falls"));
  drifting.drift_by_user = true;
  CHECK(tidal_ml(drifting) == Approx(tidal_ml(volume)).epsilon(0.01));
  drifting.drift_by_user = false, drifting.kind = SignalKind::belt;
  CHECK_THAT(error_of(drifting), Contains("the belt rises and hardly comes back"));
  CHECK(error_of(changed(volume, [](double v, double t) { return v + 60e-6 * t; })).empty());
}

TEST_CASE("A counter or a flow of one direction that was levelled is doubted", "[faults]") {
  const Record record = fourteen();
  const Trace counter = counted(volume_trace(record)), flow = flow_trace(record, 0);
  const double slope = (counter.value.back() - counter.value.front()) / counter.time_s.back();
  CHECK_THAT(notes_of(changed(counter, [&](double v, double t) { return v - slope * t; })),
             Contains("the volume falls at one rate for 40 % of the time or more") &&
                 Contains("are both directions recorded?"));
  CHECK_THAT(notes_of(changed(flow, [&](double q, double) { return std::max(q, 0.0) - slope; })),
             Contains("the volume falls at one rate"));
  CHECK_THAT(notes_of(flow), !Contains("at one rate"));
  const Trace biased = changed(flow, [](double q, double) { return std::max(q, 0.0) - 0.02e-3; });
  CHECK_THAT(error_of(biased), Contains("as if only one direction were recorded"));
}

TEST_CASE("What jumps is no breath", "[faults]") {
  const Record record = fourteen();
  const auto onsets = onsets_of(record);
  Trace counter = with_resets(counted(volume_trace(record)), onsets);
  const std::vector<double> sharp = counter.value;
  for (std::size_t i = 3; i + 3 < sharp.size(); ++i)  // resets smeared over seven samples, as of a filter
    counter.value[i] =
        (sharp[i - 3] + sharp[i - 2] + sharp[i - 1] + sharp[i] + sharp[i + 1] + sharp[i + 2] + sharp[i + 3]) /
        7;
  CHECK_THAT(error_of(counter), Contains("empties from 90 to 10 % within 0.0") && Contains("without resets"));
  Record ventilated = record;
  for (SyntheticShape& breath : ventilated.breaths) breath.ventilated = true;
  CHECK(error_of(volume_trace(ventilated)).empty());
  Record infant;
  infant.breaths.assign(20, {35e-6, 0.4, 0.5, 0.1});
  CHECK(error_of(volume_trace(infant)).empty());
}

TEST_CASE("A temperature, another unit from the middle on and too little air are doubted", "[faults]") {
  const Trace volume = volume_trace(fourteen());
  CHECK(notes_of(volume).empty());
  CHECK_THAT(notes_of(changed(volume, [](double v, double) { return 34e-3 + v; })),
             Contains("lies between 34 and 34.5 L, more than lungs hold"));
  CHECK_THAT(notes_of(changed(volume, [](double v, double) { return -34e-3 + v; })),
             Contains("more than lungs hold"));
  CHECK_THAT(notes_of(changed(volume, [](double v, double) { return 0.1 * v; })),
             Contains("breaths of 50 ml that last 4.0 s move 0.8 L/min"));
  const Trace flow = flow_trace(fourteen(), 0);
  const double middle = 0.5 * flow.time_s.back();
  for (const double factor : {1 / 16.67, 16.67}) {
    Trace mixed = changed(flow, [&](double q, double t) { return t < middle ? q : factor * q; });
    if (factor > 1) mixed = changed(mixed, [&](double q, double) { return q / factor; });
    CHECK_THAT(notes_of(mixed),
               Contains("does the unit change there") && Contains(factor < 1 ? "as small" : "as large"));
  }
  CHECK_THAT(error_of(changed(flow, [&](double q, double t) { return t < middle ? q : 60 * q; })),
             Contains("does the unit change there") && !Contains("may hold"));
  CHECK_THAT(notes_of(changed(flow, [&](double q, double t) { return t < middle ? q : 4 * q; })),
             !Contains("does the unit change"));
}

TEST_CASE("A spike beyond all others is no sign of clipping, and clipping is", "[faults]") {
  const Record record = fourteen();
  Trace flow = flow_trace(record, 0);
  for (const int samples : {1, 5, 30}) {
    Trace spiked = flow;
    for (int i = 0; i < samples; ++i) spiked.value[static_cast<std::size_t>(1000 + i)] = 0.1;
    CAPTURE(samples);
    CHECK_THAT(notes_of(spiked), !Contains("clipped"));
  }
  CHECK_THAT(notes_of(changed(flow, [](double q, double) { return std::clamp(q, -0.25e-3, 0.25e-3); })),
             Contains("at the highest value, 0.25 L/s: the signal is clipped"));
}
