#include "traces/flow_against_volume.hpp"

#include <algorithm>
#include <cmath>

#include "math/median.hpp"

namespace trunk {
namespace {

constexpr double grid_step_s = 0.1, most_of_median = 3;
constexpr int lag_steps = 30;  // either way
constexpr double lag_step_s = 0.02, surely_signed = 0.5;
constexpr double strong_part = 0.9, strong_share = 0.3;
constexpr std::size_t fewest_steps = 20;

using Values = std::vector<double>;

// => values without their mean, limited
void clip(Values& values) {
  Values sizes;
  for (const double v : values) sizes.push_back(std::abs(v));
  const double most = most_of_median * median(std::move(sizes));
  double sum = 0;
  for (double& v : values) sum += v = std::clamp(v, -most, most);
  for (double& v : values) v -= sum / static_cast<double>(values.size());
}

double product(const Values& a, const Values& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

// The steps of a recording, and what moves over each.
struct Steps {
  Values begin_s, end_s, rise;
};

Steps steps_between(const Values& time, const Values& flow, const Values& volume) {
  Steps steps;
  std::size_t begin = 0;
  bool whole = true;
  for (std::size_t i = 1; i < time.size(); ++i) {
    whole = whole && std::isfinite(flow[i] + flow[i - 1]);
    if (time[i] - time[begin] < grid_step_s) continue;
    if (whole && std::isfinite(volume[i] - volume[begin])) {
      steps.begin_s.push_back(time[begin]), steps.end_s.push_back(time[i]);
      steps.rise.push_back(volume[i] - volume[begin]);
    }
    begin = i, whole = true;
  }
  return steps;
}

// The integral of a flow at any time.
class Moved {
 public:
  Moved(const Values& time, const Values& flow) : time_(time), sum_(time.size(), 0.0) {
    for (std::size_t i = 1; i < time.size(); ++i) {
      const double area = 0.5 * (flow[i] + flow[i - 1]) * (time[i] - time[i - 1]);
      sum_[i] = sum_[i - 1] + (std::isfinite(area) ? area : 0);
    }
  }

  Values over(const Steps& steps, double lag_s) const {
    Values moved;
    std::size_t from = 1, until = 1;
    for (std::size_t i = 0; i < steps.rise.size(); ++i)
      moved.push_back(at(steps.end_s[i] - lag_s, until) - at(steps.begin_s[i] - lag_s, from));
    return moved;
  }

 private:
  // Times increase from call to call. => next
  double at(double time_s, std::size_t& next) const {
    while (next + 1 < time_.size() && time_[next] < time_s) ++next;
    const double part = (time_s - time_[next - 1]) / (time_[next] - time_[next - 1]);
    return sum_[next - 1] + std::clamp(part, 0.0, 1.0) * (sum_[next] - sum_[next - 1]);
  }

  const Values& time_;
  Values sum_;
};

double correlation(Values moved, const Values& rise) {
  clip(moved);
  const double size = std::sqrt(product(moved, moved) * product(rise, rise));
  return size > 0 ? product(moved, rise) / size : 0;
}

double gain_of(const Values& moved, const Values& rise, double sign) {
  Values sizes, gains;
  for (const double m : moved) sizes.push_back(std::abs(m));
  const auto nth =
      sizes.begin() + static_cast<std::ptrdiff_t>(strong_part * static_cast<double>(sizes.size() - 1));
  std::nth_element(sizes.begin(), nth, sizes.end());
  const double least = strong_share * *nth;
  for (std::size_t i = 0; i < moved.size(); ++i)
    if (std::abs(moved[i]) >= least && sign * moved[i] * rise[i] > 0)
      gains.push_back(std::abs(rise[i] / moved[i]));
  return median(std::move(gains));
}

}  // namespace

FlowAgainstVolume flow_against_volume(const Values& time_s, const Values& flow, const Values& volume) {
  const Steps steps = steps_between(time_s, flow, volume);
  FlowAgainstVolume found;
  if (steps.rise.size() < fewest_steps) return found;
  const Moved moved(time_s, flow);
  Values rise = steps.rise;
  clip(rise);
  found.along = found.best = correlation(moved.over(steps, 0), rise);
  found.seen = product(rise, rise) > 0 && found.along != 0;
  if (!found.seen) return found;
  for (int step = -lag_steps; step <= lag_steps; ++step) {
    const double lag = lag_step_s * step;
    const double now = correlation(moved.over(steps, lag), rise);
    if (std::abs(found.along) >= surely_signed && now * found.along < 0) continue;
    if (std::abs(now) > std::abs(found.best)) found.best = now, found.lag_s = lag;
  }
  found.gain = gain_of(moved.over(steps, found.lag_s), steps.rise, found.best);
  return found;
}

}  // namespace trunk
