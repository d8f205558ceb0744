#pragma once

#include <span>
#include <vector>

namespace trunk {

/// A function of time through knots, straight between them; `time` increases strictly, both have one length
/// >= 1.
struct KnotLine {
  std::vector<double> time, value;

  /// The value at t; before the first and after the last knot the line goes on with `slope_outside`.
  double operator()(double t, double slope_outside = 0) const;
};

/// The signal at time t, straight between samples; held outside. `time` increases strictly.
double interpolated(std::span<const double> time, std::span<const double> signal, double t);

}  // namespace trunk
