#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace trunk {

/// A function of time through knots. `time` increases strictly; `time` and `value` have the same length, at
/// least 1. Between two knots it is a line, bent as much as the curvatures at both have in common: that is
/// none if they differ in sign, at a step or where knots scatter, and nearly all of a slow wave.
struct KnotLine {
  std::vector<double> time, value;

  /// Returns the value at t; outside the knots the line continues with `slope_outside`.
  double operator()(double t, double slope_outside = 0) const;

 private:
  /// Returns the second divided difference at an inner knot; 0 at the ends.
  double curvature(std::size_t i) const;
};

/// Returns the signal at time t, linear between samples and constant outside. `time` increases strictly.
double interpolated(std::span<const double> time, std::span<const double> signal, double t);

}  // namespace trunk
