#include "traces/read_trace.hpp"

#include <fmt/format.h>

#include <cmath>

#include "math/units.hpp"
#include "recordings/open_recording.hpp"
#include "text/message_text.hpp"
#include "traces/check_other.hpp"
#include "traces/raw_samples.hpp"
#include "traces/read_channel.hpp"
#include "traces/sample_times.hpp"

namespace trunk {
namespace {

constexpr std::size_t min_samples = 10;

Trace empty_trace(const TraceColumns& columns, const std::string& source) {
  Trace trace;
  trace.source = source;
  trace.notes = columns.notes;
  trace.kind = columns.kind;
  if (columns.time) trace.time_unit = columns.all[*columns.time].unit;
  trace.value_unit = columns.all[columns.value].unit;
  for (const std::string& note : columns.channels.notes) trace.notes.push_back(note);
  trace.excursion_m = columns.channels.excursion_m;
  return trace;
}

void check_enough_samples(const RawSamples& samples, const Recording& recording) {
  if (samples.size() == 0)
    throw InputError({recording.source, recording.header_line}, "a header without rows of numbers below it",
                     fmt::format("at least {} samples", min_samples), "check that the export was finished");
  if (samples.size() < min_samples)
    throw samples.error(fmt::format("{} sample{} found", samples.size(), samples.size() == 1 ? "" : "s"),
                        fmt::format("at least {}", min_samples), "give a recording of one breath or more");
}

void check_positive(const std::vector<double>& sigma_m3, const RawSamples& samples) {
  Mistakes mistakes;
  for (std::size_t i = 0; i < sigma_m3.size(); ++i)
    if (!(sigma_m3[i] > 0))
      mistakes.add(samples.mistake_at(i, fmt::format("sigma {} found", number_text(sigma_m3[i] * ml_per_m3)),
                                      "a standard deviation above 0", "correct it or remove the column"));
  mistakes.settle();
}

// Adds the channels beside the signal. => trace
void add_channels(Recording& recording, const TraceColumns& columns, const UsedSamples& used, Trace& trace) {
  Mistakes mistakes;
  for (const ChannelColumn& column : columns.channels.columns)
    mistakes.gather([&] {
      trace.channels.push_back(
          read_channel(recording, column, columns.all[column.column].text, used, trace.time_s, trace.notes));
    });
  mistakes.settle();
}

}  // namespace

Trace read_trace(const std::filesystem::path& path, const TraceOptions& options) {
  const auto recording = open_recording(path, {options.encoding, options.block});
  const TraceColumns columns = choose_columns(*recording, options);
  Trace trace = empty_trace(columns, path.string());
  RawSamples samples(*recording, columns);
  trace.notes.insert(trace.notes.end(), recording->notes.begin(), recording->notes.end());
  check_enough_samples(samples, *recording);
  samples.leave_out_other_rates(trace.notes);
  const ColumnName* clock = columns.time ? &columns.all[*columns.time] : nullptr;
  Mistakes mistakes;
  if (!mistakes.gather([&] { samples.bridge_missing(trace.notes); })) {
    if (clock) mistakes.gather([&] { check_increases(samples.time_of_whole_samples_s(), samples, *clock); });
    mistakes.settle();
  }
  check_enough_samples(samples, *recording);
  trace.time_s = samples.time_s();
  trace.value = samples.value();
  trace.sigma_m3 = samples.sigma_m3();
  mistakes.gather([&] { settle_times(trace.time_s, samples, clock, trace.notes); });
  mistakes.gather([&] { check_positive(trace.sigma_m3, samples); });
  mistakes.settle();
  trace.inverted_by_user = options.invert;
  trace.drift_by_user = options.remove_drift;
  check_other(*recording, columns, samples.used(), trace);
  add_channels(*recording, columns, samples.used(), trace);
  return trace;
}

}  // namespace trunk
