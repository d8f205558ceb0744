#include "traces/flow_sign.hpp"

#include <algorithm>
#include <cmath>

#include "math/median.hpp"

namespace trunk {
namespace {

constexpr double step_s = 0.1, most_of_median = 3;
constexpr std::size_t fewest_steps = 20;

// => values without their mean, limited
void limit(std::vector<double>& values) {
  std::vector<double> sizes;
  for (const double v : values) sizes.push_back(std::abs(v));
  const double most = most_of_median * median(std::move(sizes));
  double sum = 0;
  for (double& v : values) sum += v = std::clamp(v, -most, most);
  for (double& v : values) v -= sum / static_cast<double>(values.size());
}

double product(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

}  // namespace

double flow_along_volume(const std::vector<double>& time, const std::vector<double>& flow,
                         const std::vector<double>& volume) {
  std::vector<double> moved, rise;
  double area = 0;
  std::size_t begin = 0;
  for (std::size_t i = 1; i < time.size(); ++i) {
    area += 0.5 * (flow[i] + flow[i - 1]) * (time[i] - time[i - 1]);
    if (time[i] - time[begin] < step_s) continue;
    if (std::isfinite(area) && std::isfinite(volume[i] - volume[begin]))
      moved.push_back(area), rise.push_back(volume[i] - volume[begin]);
    area = 0, begin = i;
  }
  if (moved.size() < fewest_steps) return 0;
  limit(moved);
  limit(rise);
  const double size = std::sqrt(product(moved, moved) * product(rise, rise));
  return size > 0 ? product(moved, rise) / size : 0;
}

}  // namespace trunk
