#include "breaths/zero_pulses.hpp"

#include <algorithm>
#include <cmath>

#include "math/median.hpp"

namespace trunk {
namespace {

constexpr double near_zero = 0.004, clear_jump = 0.1, any_jump = 0.015;  // of the central range
constexpr std::size_t fewest_samples = 3;
constexpr double shortest_pulse_s = 0.03, clear_pulse_s = 0.1, longest_pulse_s = 1;
constexpr double alike_lengths = 0.1;
constexpr std::ptrdiff_t enough_pulses = 2;

using Flow = std::span<const double>;

double range_of(Flow flow) {
  std::vector<double> sorted(flow.begin(), flow.end());
  std::sort(sorted.begin(), sorted.end());
  return sorted[sorted.size() * 19 / 20] - sorted[sorted.size() / 20];
}

// Says whether the flow jumps from one sample to the next, and is not on its way there one sample before.
bool jumps(Flow flow, std::size_t outside, std::size_t beyond) {
  return std::abs(flow[beyond] - flow[outside]) < 0.5 * std::abs(flow[outside]) &&
         flow[beyond] * flow[outside] > 0;
}

struct Candidate {
  ZeroPulse pulse;
  bool same_side;
};

// Returns the parts near zero that begin and end with a jump, one of them a clear one.
std::vector<Candidate> candidates_in(Flow time, Flow flow) {
  const double range = range_of(flow), level = near_zero * range;
  std::vector<Candidate> found;
  for (std::size_t first = 2, last = 0; first + 2 < flow.size(); first = last + 1) {
    last = first;
    if (std::abs(flow[first]) > level) continue;
    while (last + 1 < flow.size() && std::abs(flow[last + 1]) <= level) ++last;
    if (last + 2 >= flow.size()) break;
    const double length = time[last + 1] - time[first];
    const double before = std::abs(flow[first - 1]), after = std::abs(flow[last + 1]);
    if (length < shortest_pulse_s || length > longest_pulse_s) continue;
    if (last + 1 < first + fewest_samples) continue;
    if (std::max(before, after) < clear_jump * range || std::min(before, after) < any_jump * range) continue;
    if (jumps(flow, first - 1, first - 2) && jumps(flow, last + 1, last + 2))
      found.push_back({{first, last}, flow[first - 1] * flow[last + 1] > 0});
  }
  return found;
}

double length_of(const ZeroPulse& pulse) {
  return static_cast<double>(pulse.last - pulse.first + 1);
}

struct Straight {
  double value, slope;
};

// Returns the least-squares line through samples, at a time.
Straight line_at(Flow time, Flow flow, std::size_t first, std::size_t last, double t) {
  const auto n = static_cast<double>(last - first + 1);
  double mean_time = 0, mean = 0, covariance = 0, variance = 0;
  for (std::size_t i = first; i <= last; ++i) mean_time += time[i] / n, mean += flow[i] / n;
  for (std::size_t i = first; i <= last; ++i) {
    covariance += (time[i] - mean_time) * (flow[i] - mean);
    variance += (time[i] - mean_time) * (time[i] - mean_time);
  }
  return {mean + covariance / variance * (t - mean_time), covariance / variance};
}

}  // namespace

std::vector<ZeroPulse> zero_pulses(Flow time, Flow flow) {
  const std::vector<Candidate> candidates = candidates_in(time, flow);
  std::vector<double> lengths;
  for (const Candidate& c : candidates)
    if (c.same_side) lengths.push_back(length_of(c.pulse));
  const auto alike = [&](double one, double other) {
    return std::abs(one - other) <= std::max(alike_lengths * other, 1.0);
  };
  const double usual = median(lengths);
  const bool repeated = std::count_if(lengths.begin(), lengths.end(),
                                      [&](double l) { return alike(l, usual); }) >= enough_pulses;
  std::vector<ZeroPulse> pulses;
  for (const Candidate& c : candidates) {
    const bool one_of_many = repeated && alike(length_of(c.pulse), usual);
    const bool clear = c.same_side && time[c.pulse.last + 1] - time[c.pulse.first] >= clear_pulse_s;
    if (one_of_many || clear) pulses.push_back(c.pulse);
  }
  return pulses;
}

void bridge(Flow time, const std::vector<ZeroPulse>& pulses, std::vector<double>& flow) {
  for (const ZeroPulse& pulse : pulses) {
    const std::size_t around = std::max<std::size_t>((pulse.last - pulse.first + 1) / 3, 2);
    const std::size_t left = pulse.first - 1, right = pulse.last + 1;
    const double length = time[right] - time[left];
    const Straight from = line_at(time, flow, left - std::min(around, left), left, time[left]);
    const Straight to = line_at(time, flow, right, std::min(right + around, flow.size() - 1), time[right]);
    for (std::size_t i = pulse.first; i <= pulse.last; ++i) {
      const double p = (time[i] - time[left]) / length, q = 1 - p;
      flow[i] = q * q * (1 + 2 * p) * from.value + p * p * (1 + 2 * q) * to.value +
                p * q * length * (q * from.slope - p * to.slope);
    }
  }
}

}  // namespace trunk
