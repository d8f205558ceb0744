#include "breaths/volume_signal.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "breaths/robust.hpp"
#include "errors/input_error.hpp"
#include "io/message_text.hpp"

namespace trunk {
namespace {

void check_varies(const Trace& trace) {
  const auto [low, high] = std::minmax_element(trace.value.begin(), trace.value.end());
  if (*low < *high) return;
  const bool flow = trace.kind == SignalKind::flow;
  throw InputError(
      trace.source, 0,
      "all " + std::to_string(trace.value.size()) + " samples of the " + (flow ? "flow" : "volume") +
          " are " + number_text(*low * (flow ? 1e3 : 1e6)) + (flow ? " L/s" : " ml") +
          "; expected a signal that varies with breathing; check the sensor or choose another column");
}

// The range without its outer 5 % on either side: what a few wild samples cannot change.
double central_range(std::vector<double> values) {
  const auto at = [&](double part) {
    const auto i = static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + i, values.end());
    return values[static_cast<std::size_t>(i)];
  };
  const double low = at(0.05);
  return at(0.95) - low;
}

// The largest step between the samples around step i (from i-1 to i), the steps in [skip_first, skip_last]
// excepted.
double step_nearby(std::span<const double> signal, std::size_t skip_first, std::size_t skip_last) {
  constexpr std::size_t reach = 3;
  double largest = 0;
  const std::size_t first = skip_first > reach ? skip_first - reach : 1;
  for (std::size_t k = first; k <= std::min(skip_last + reach, signal.size() - 1); ++k)
    if (k < skip_first || k > skip_last) largest = std::max(largest, std::abs(signal[k] - signal[k - 1]));
  return largest;
}

// A spike leaves and comes back at once. Our choice: a fifth of the central range, ten times the steps
// nearby.
std::size_t repair_spikes(std::vector<double>& signal) {
  const double least = 0.2 * central_range(signal);
  std::size_t repaired = 0;
  for (std::size_t i = 1; i + 1 < signal.size(); ++i) {
    const double up = signal[i] - signal[i - 1], down = signal[i] - signal[i + 1];
    const double height = std::min(std::abs(up), std::abs(down));
    if (up * down <= 0 || height <= least) continue;
    if (height <= 10 * step_nearby(signal, i, i + 1)) continue;
    signal[i] = 0.5 * (signal[i - 1] + signal[i + 1]);
    ++repaired;
  }
  return repaired;
}

std::vector<double> integrated(std::span<const double> time, std::span<const double> flow) {
  std::vector<double> volume(flow.size(), 0.0);
  for (std::size_t i = 1; i < flow.size(); ++i)
    volume[i] = volume[i - 1] + 0.5 * (flow[i] + flow[i - 1]) * (time[i] - time[i - 1]);
  return volume;
}

// A reset lands on zero from a distance the steps around it do not explain. Our choice: 4 times those steps,
// at least 1 % of the range, and zero to within 2 % of the range. Smaller jumps are left: they count as
// drift.
std::size_t remove_resets(std::vector<double>& volume) {
  const std::vector<double> raw = volume;
  const double range = central_range(raw);
  double offset = 0;
  std::size_t resets = 0;
  for (std::size_t i = 1; i < raw.size(); ++i) {
    const double jump = raw[i] - raw[i - 1], nearby = step_nearby(raw, i, i);
    const bool lands_on_zero = std::abs(raw[i]) <= 0.02 * range;
    // A jump is followed by ordinary steps; an outlier would step back.
    if (lands_on_zero && std::abs(jump) > 0.05 * range && std::abs(jump) > 4 * nearby) {
      const double step_before = i >= 2 ? raw[i - 1] - raw[i - 2] : 0;
      offset += step_before - jump;
      ++resets;
    }
    volume[i] = raw[i] + offset;
  }
  return resets;
}

}  // namespace

VolumeSignal volume_signal(const Trace& trace) {
  check_varies(trace);
  VolumeSignal signal{trace.time_s, trace.value, {}};
  const auto note = [&](std::size_t count, const std::string& what) {
    if (count > 0) signal.notes.push_back(std::to_string(count) + " " + what);
  };
  note(repair_spikes(signal.volume_m3),
       "isolated spike(s) of one sample replaced by the mean of their neighbours");
  if (trace.kind == SignalKind::flow)
    signal.volume_m3 = integrated(signal.time_s, signal.volume_m3);
  else
    note(remove_resets(signal.volume_m3), "reset(s) of the volume to zero undone");
  return signal;
}

}  // namespace trunk
