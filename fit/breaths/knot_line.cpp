#include "breaths/knot_line.hpp"

#include <algorithm>
#include <cmath>

namespace trunk {

double KnotLine::operator()(double t, double slope_outside) const {
  if (t <= time.front()) return value.front() + slope_outside * (t - time.front());
  if (t >= time.back()) return value.back() + slope_outside * (t - time.back());
  const auto above = std::upper_bound(time.begin(), time.end(), t);
  const auto i = static_cast<std::size_t>(above - time.begin());
  const double one = curvature(i - 1), other = curvature(i);
  const double bend = one * other <= 0 ? 0 : std::abs(one) < std::abs(other) ? one : other;
  const double part = (t - time[i - 1]) / (time[i] - time[i - 1]);
  return value[i - 1] + part * (value[i] - value[i - 1]) + bend * (t - time[i - 1]) * (t - time[i]);
}

double KnotLine::curvature(std::size_t i) const {
  if (i == 0 || i + 1 >= time.size()) return 0;
  const auto slope = [&](std::size_t k) { return (value[k + 1] - value[k]) / (time[k + 1] - time[k]); };
  return (slope(i) - slope(i - 1)) / (time[i + 1] - time[i - 1]);
}

double interpolated(std::span<const double> time, std::span<const double> signal, double t) {
  const auto above = std::upper_bound(time.begin(), time.end(), t);
  if (above == time.begin()) return signal.front();
  if (above == time.end()) return signal.back();
  const auto i = static_cast<std::size_t>(above - time.begin());
  const double part = (t - time[i - 1]) / (time[i] - time[i - 1]);
  return signal[i - 1] + part * (signal[i] - signal[i - 1]);
}

}  // namespace trunk
