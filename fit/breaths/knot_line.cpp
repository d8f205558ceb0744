#include "breaths/knot_line.hpp"

#include <algorithm>

namespace trunk {

double KnotLine::operator()(double t, double slope_outside) const {
  if (t <= time.front()) return value.front() + slope_outside * (t - time.front());
  if (t >= time.back()) return value.back() + slope_outside * (t - time.back());
  return interpolated(time, value, t);
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
