#pragma once

#include <span>
#include <vector>

namespace trunk {

/// A function of time, linear between knots. `time` increases strictly; `time` and `value` have the same
/// length, at least 1.
struct KnotLine {
  std::vector<double> time, value;

  /// Returns the value at t; outside the knots the line continues with `slope_outside`.
  double operator()(double t, double slope_outside = 0) const;
};

/// Returns the signal at time t, linear between samples and constant outside. `time` increases strictly.
double interpolated(std::span<const double> time, std::span<const double> signal, double t);

}  // namespace trunk
