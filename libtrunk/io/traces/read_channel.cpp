#include "traces/read_channel.hpp"

#include <cmath>

#include "traces/raw_samples.hpp"

namespace trunk {
namespace {

constexpr double least_part = 0.5;  // of the samples, with a number

struct Repair {
  std::size_t bridged = 0, gaps = 0;  // samples; gaps that stay
  double first_gap_s = 0, longest_gap_s = 0;
};

// Interpolates short runs of samples without a number. => value
Repair bridge(const std::vector<double>& time, std::vector<double>& value) {
  Repair repair;
  for (std::size_t begin = 0; begin < value.size(); ++begin) {
    if (std::isfinite(value[begin])) continue;
    std::size_t end = begin;
    while (end < value.size() && !std::isfinite(value[end])) ++end;
    const bool inside = begin > 0 && end < value.size();
    const double length = time[end < value.size() ? end : end - 1] - time[begin > 0 ? begin - 1 : begin];
    // A single sample counts as short whatever the rate is.
    if (inside && (length <= longest_bridge_s || end == begin + 1)) {
      const double before = value[begin - 1], slope = (value[end] - before) / length;
      for (std::size_t i = begin; i < end; ++i) value[i] = before + slope * (time[i] - time[begin - 1]);
      repair.bridged += end - begin;
    } else {
      for (std::size_t i = begin; i < end; ++i) value[i] = NAN;
      if (repair.gaps++ == 0) repair.first_gap_s = time[begin];
      repair.longest_gap_s = std::max(repair.longest_gap_s, length);
    }
    begin = end;
  }
  return repair;
}

void check_filled(const Samples& samples, const std::vector<double>& value, const Recording& recording,
                  const std::string& name, const ChannelColumn& column) {
  std::size_t finite = 0;
  for (const double v : value) finite += std::isfinite(v) ? 1 : 0;
  if (static_cast<double>(finite) >= least_part * static_cast<double>(value.size())) return;
  const std::string first =
      samples.flaws.empty() ? "" : fmt::format("; the first fault: {}", samples.flaws.front().mistake.found);
  throw InputError({recording.source},
                   fmt::format("{} of {} samples of {} {} have a number{}", finite, value.size(),
                               recording.word, excerpt(name), first),
                   "at least half of them",
                   fmt::format("correct the column, or leave it out with --{} none", option_of(column.kind)));
}

}  // namespace

TraceChannel read_channel(Recording& recording, const ChannelColumn& column, const std::string& name,
                          const UsedSamples& used, const std::vector<double>& time_s,
                          std::vector<std::string>& notes) {
  const std::size_t chosen[] = {column.column};
  Samples samples = recording.read(chosen);
  if (!used.rows.empty()) bridge(used.all_time_s, samples.values[0]);  // its numbers may be in other rows
  TraceChannel channel{column.kind, name, column.unit, used.of(samples.values[0], time_s.size())};
  for (double& value : channel.value) value *= column.to_si;
  const Repair repair = bridge(time_s, channel.value);
  check_filled(samples, channel.value, recording, name, column);
  const std::string word_and_name = fmt::format("{} {}", recording.word, excerpt(name));
  if (repair.bridged > 0)
    notes.push_back(fmt::format("{} sample{} of {} without a number interpolated", repair.bridged,
                                repair.bridged == 1 ? "" : "s", word_and_name));
  if (repair.gaps > 0)
    notes.push_back(
        fmt::format("{} has {} gap{} of up to {} s, the first at {} s: breaths in it do not count for it",
                    word_and_name, repair.gaps, repair.gaps == 1 ? "" : "s",
                    number_text(repair.longest_gap_s, 3), number_text(repair.first_gap_s, 6)));
  return channel;
}

}  // namespace trunk
