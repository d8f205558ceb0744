#include "gates/flow_signs.hpp"

#include <algorithm>
#include <cmath>

#include "breaths/robust.hpp"
#include "math/median.hpp"

namespace trunk {
namespace {

constexpr double allowed_noise = 0.03;  // of the peak flow
constexpr double widest_s = 0.06;
constexpr double below_peak = 0.95;      // of the samples of an inspiration
constexpr double low = 0.1, high = 0.9;  // of the peak flow: begin and end of its rise

// A flow between samples of a volume.
struct Flow {
  std::vector<double> time_s, value;
  double step_s = 0;

  std::size_t first_after(double t) const {
    return static_cast<std::size_t>(std::lower_bound(time_s.begin(), time_s.end(), t) - time_s.begin());
  }
};

Flow flow_of(const Segmentation& s) {
  Flow flow;
  for (std::size_t i = 1; i < s.time_s.size(); ++i) {
    flow.time_s.push_back(0.5 * (s.time_s[i] + s.time_s[i - 1]));
    flow.value.push_back((s.volume_m3[i] - s.volume_m3[i - 1]) / (s.time_s[i] - s.time_s[i - 1]));
  }
  flow.step_s = (s.time_s.back() - s.time_s.front()) / static_cast<double>(s.time_s.size() - 1);
  return flow;
}

// Returns what 5 % of the samples [first, end) exceed; first < end.
double peak_of(const Flow& flow, std::size_t first, std::size_t end) {
  std::vector<double> values(&flow.value[first], &flow.value[first] + (end - first));
  const auto at = static_cast<std::ptrdiff_t>(below_peak * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

double median_peak_flow(const Flow& flow, const std::vector<Breath>& breaths) {
  std::vector<double> peaks;
  for (const Breath& b : breaths) {
    const std::size_t onset = flow.first_after(b.onset_s), peak = flow.first_after(b.peak_s);
    if (onset < peak) peaks.push_back(peak_of(flow, onset, peak));
  }
  return median(std::move(peaks));
}

// Returns the time at which a signal crosses a level between samples i-1 and i.
double crossing(const Flow& flow, std::size_t i, double level) {
  const double before = flow.value[i - 1], after = flow.value[i];
  const double part = after == before ? 0 : std::clamp((level - before) / (after - before), 0.0, 1.0);
  return flow.time_s[i - 1] + part * (flow.time_s[i] - flow.time_s[i - 1]);
}

double rise_of(const Flow& flow, std::size_t first, std::size_t end) {
  const double peak = peak_of(flow, first, end);
  std::size_t upper = first;
  while (upper + 1 < end && flow.value[upper] < high * peak) ++upper;
  std::size_t lower = upper;
  while (lower > 0 && flow.value[lower - 1] > low * peak) --lower;
  if (lower == 0 || peak <= 0) return std::nan("");
  return crossing(flow, upper, high * peak) - crossing(flow, lower, low * peak);
}

double release_of(const Flow& flow, std::size_t first, std::size_t end, std::size_t earliest) {
  const auto bottom = static_cast<std::size_t>(
      std::min_element(&flow.value[first], &flow.value[first] + (end - first)) - flow.value.data());
  std::size_t turn = bottom;
  while (turn > earliest && flow.value[turn - 1] < 0) --turn;
  if (turn == 0) return std::nan("");
  return flow.time_s[bottom] - crossing(flow, turn, 0);
}

}  // namespace

FlowSigns flow_signs(const Segmentation& segmentation, const std::vector<Breath>& breaths) {
  Flow flow = flow_of(segmentation);
  const double noise = noise_deviation(flow.value);
  const auto widest = static_cast<std::size_t>(std::max(1.0, widest_s / flow.step_s));
  const std::size_t width = averaging_width(noise, allowed_noise * median_peak_flow(flow, breaths), widest);
  flow.value = moving_average(flow.value, width);
  FlowSigns signs;
  std::vector<double> rises, releases, periods;
  for (const Breath& b : breaths) {
    periods.push_back(b.duration_s());
    const std::size_t onset = flow.first_after(b.onset_s), peak = flow.first_after(b.peak_s),
                      end = flow.first_after(b.end_s);
    if (onset >= peak || peak >= end) continue;
    if (const double rise = rise_of(flow, onset, peak); std::isfinite(rise)) rises.push_back(rise);
    if (const double release = release_of(flow, peak, end, onset); std::isfinite(release))
      releases.push_back(release);
  }
  signs.rise_s = median(std::move(rises));
  signs.release_s = median(std::move(releases));
  signs.period_s = median(std::move(periods));
  return signs;
}

}  // namespace trunk
