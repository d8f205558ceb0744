#pragma once

#include <span>
#include <vector>

namespace trunk {

/// Returns the standard deviation of white noise on a smooth, evenly sampled signal, in the signal's unit; 0
/// for fewer than 5 samples. It is the median absolute fourth difference over its expected value, 0.6745
/// sqrt(70) sigma. The fourth difference of a breath with 20 or more samples is negligible, and the median
/// ignores jumps.
double noise_deviation(std::span<const double> signal);

/// Returns the value below which a part (0 to 1) of all values lies. values: [1 or more].
double quantile(std::vector<double> values, double part);

/// Returns the centred moving average over `width` samples (odd). The width shrinks towards the ends, so the
/// average shifts nothing in time.
std::vector<double> moving_average(std::span<const double> signal, std::size_t width);

/// Returns the narrowest odd width, at most `widest`, whose average reduces white noise from `noise` to
/// `allowed`.
std::size_t averaging_width(double noise, double allowed, std::size_t widest);

}  // namespace trunk
