#include "breaths/volume_signal.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>

#include "breaths/robust.hpp"
#include "breaths/zero_pulses.hpp"
#include "errors/input_error.hpp"
#include "math/median.hpp"
#include "math/units.hpp"
#include "text/message_text.hpp"

namespace trunk {
namespace {

std::string value_text(const Trace& trace, double value) {
  if (trace.kind == SignalKind::belt) return number_text(value);
  return trace.kind == SignalKind::flow ? number_text(value * litres_per_m3) + " L/s"
                                        : number_text(value * ml_per_m3) + " ml";
}

void check_varies(const Trace& trace) {
  const auto [low, high] = std::minmax_element(trace.value.begin(), trace.value.end());
  if (*low < *high) return;
  const bool flow = trace.kind == SignalKind::flow, belt = trace.kind == SignalKind::belt;
  throw InputError({trace.source},
                   "all " + std::to_string(trace.value.size()) + " samples of the " +
                       (flow   ? "flow"
                        : belt ? "belt"
                               : "volume") +
                       " are " + value_text(trace, *low),
                   "a signal that varies with breathing", "check the sensor or choose another column");
}

// Returns a note if the signal is clipped: then nearly all samples in a range near the extreme are also in a
// range a quarter as wide. A smooth top has half of them there, and a sharp top a quarter (our choice: 65 %
// of them, and 1 % of all samples). A level that the signal reaches by a jump, like a ventilator's constant
// flow, does not count.
std::string saturation(const Trace& trace, const std::vector<double>& values, double extreme, double range,
                       const std::string& which) {
  const auto within = [&](std::size_t i, double distance) {
    return std::abs(values[i] - extreme) <= distance * range;
  };
  double near = 0, wide = 0, jumps = 0, entries = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    near += within(i, 0.01) ? 1 : 0;
    wide += within(i, 0.04) ? 1 : 0;
    if (i == 0 || !within(i, 0.01) || within(i - 1, 0.01)) continue;
    ++entries;
    jumps += i == 1 || within(i - 2, 0.2) ? 0 : 1;
  }
  const double part = near / static_cast<double>(values.size());
  if (near < 5 || part < 0.01 || near < 0.65 * wide || jumps > 0.5 * entries) return "";
  return number_text(100 * part, 2) + " % of the samples lie at the " + which + " value, " +
         value_text(trace, extreme) + ": the signal is clipped, or held there";
}

// Returns the range without the outer 5 % on either side, so that a few wild samples do not change it.
double central_range(std::vector<double> values) {
  const auto at = [&](double part) {
    const auto i = static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + i, values.end());
    return values[static_cast<std::size_t>(i)];
  };
  const double low = at(0.05);
  return at(0.95) - low;
}

// The values are without spikes, and a long one must not widen what counts as near.
void note_saturation(const Trace& trace, const std::vector<double>& values, std::vector<std::string>& notes) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const double range = std::min(*high - *low, 2 * central_range(values));
  notes.push_back(saturation(trace, values, *high, range, "highest"));
  // A volume may rest at its lowest value, so only a flow is checked there.
  if (trace.kind == SignalKind::flow) notes.push_back(saturation(trace, values, *low, range, "lowest"));
  std::erase(notes, "");
}

// Returns the sizes of the three steps on either side of the steps [skip_first, skip_last]; step i goes from
// sample i-1 to i.
std::vector<double> steps_nearby(std::span<const double> signal, std::size_t skip_first,
                                 std::size_t skip_last) {
  constexpr std::size_t reach = 3;
  std::vector<double> steps;
  const std::size_t first = skip_first > reach ? skip_first - reach : 1;
  for (std::size_t k = first; k <= std::min(skip_last + reach, signal.size() - 1); ++k)
    if (k < skip_first || k > skip_last) steps.push_back(std::abs(signal[k] - signal[k - 1]));
  return steps;
}

// Returns the length of a spike that begins at sample i, or 0. A spike jumps away, stays on one side and
// jumps back, nearly to where it left. Our choice: jumps above a fifth of the central range, above six
// deviations of the noise and above five times the median step nearby, and a return to within half the
// height.
std::size_t spike_at(std::span<const double> signal, std::size_t i, std::size_t longest, double least) {
  const double before = signal[i - 1], up = signal[i] - before;
  if (std::abs(up) <= least) return 0;
  const double side = up > 0 ? 1 : -1;
  double lowest = std::abs(up);
  for (std::size_t k = 1; k <= longest && i + k < signal.size(); ++k) {
    const double back = side * (signal[i + k - 1] - signal[i + k]), left = side * (signal[i + k] - before);
    if (back > least && std::abs(left) < 0.5 * lowest &&
        std::min(std::abs(up), back) > 5 * median(steps_nearby(signal, i, i + k)))
      return k;
    lowest = std::min(lowest, left);
    if (lowest <= least) return 0;
  }
  return 0;
}

// Repairs spikes of up to five samples and a tenth of a second, and always those of one sample. Returns how
// many.
std::size_t repair_spikes(std::span<const double> time, std::vector<double>& signal) {
  const double least = std::max(0.2 * central_range(signal), 6 * noise_deviation(signal));
  const double step = (time.back() - time.front()) / static_cast<double>(time.size() - 1);
  const auto longest = static_cast<std::size_t>(std::clamp(0.1 / step, 1.0, 5.0));
  std::size_t repaired = 0;
  for (std::size_t i = 1; i + 1 < signal.size(); ++i) {
    const std::size_t length = spike_at(signal, i, longest, least);
    if (length == 0) continue;
    const double before = signal[i - 1], after = signal[i + length];
    for (std::size_t k = 0; k < length; ++k)
      signal[i + k] =
          before + (after - before) * static_cast<double>(k + 1) / static_cast<double>(length + 1);
    i += length - 1;
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

double largest(const std::vector<double>& values) {
  return values.empty() ? 0 : *std::max_element(values.begin(), values.end());
}

std::string note_of(const std::vector<ZeroPulse>& pulses, std::span<const double> time) {
  std::vector<double> lengths;
  for (const ZeroPulse& pulse : pulses) lengths.push_back(time[pulse.last + 1] - time[pulse.first]);
  return std::to_string(pulses.size()) + " pulse(s) of " + number_text(median(std::move(lengths)), 2) +
         " s at zero flow, the first at " + number_text(time[pulses.front().first]) +
         " s, as of a flowmeter that zeroes itself: the flow is bridged there";
}

// Undoes resets and returns how many. A reset jumps to zero by more than the steps around it explain. Our
// choice: 2.5 times those steps, at least 5 % of the range and 8 deviations of the noise, and zero to within
// 2 % of the range. Smaller jumps stay; they count as drift.
std::size_t remove_resets(std::vector<double>& volume) {
  const std::vector<double> raw = volume;
  const double range = central_range(raw);
  const double least = std::max(0.05 * range, 8 * noise_deviation(raw));
  double offset = 0;
  std::size_t resets = 0;
  for (std::size_t i = 1; i < raw.size(); ++i) {
    const double jump = raw[i] - raw[i - 1];
    const bool lands_on_zero = std::abs(raw[i]) <= 0.02 * range;
    // Ordinary steps follow a jump; an outlier would step back.
    if (lands_on_zero && std::abs(jump) > least && std::abs(jump) > 2.5 * largest(steps_nearby(raw, i, i))) {
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
  const std::size_t spikes = repair_spikes(signal.time_s, signal.volume);
  note_saturation(trace, signal.volume, signal.notes);
  const auto note = [&](std::size_t count, const std::string& what) {
    if (count > 0) signal.notes.push_back(std::to_string(count) + " " + what);
  };
  note(spikes, "spike(s) replaced by a line between the samples beside them");
  if (trace.kind == SignalKind::flow) {
    const auto pulses = zero_pulses(signal.time_s, signal.volume);
    if (!pulses.empty()) signal.notes.push_back(note_of(pulses, signal.time_s));
    bridge(signal.time_s, pulses, signal.volume);
    signal.volume = integrated(signal.time_s, signal.volume);
  } else
    note(remove_resets(signal.volume), "reset(s) of the volume to zero undone");
  return signal;
}

}  // namespace trunk
