#pragma once

#include <span>
#include <vector>

namespace trunk {

/// Standard deviation of white noise on a smooth signal sampled evenly (unit of the signal): the median
/// absolute fourth difference over its expected value, 0.6745 sqrt(70) sigma. The fourth difference of a
/// breath sampled 20 times or more is negligible, and the median ignores jumps. 0 for fewer than 5 samples.
double noise_deviation(std::span<const double> signal);

/// Centred moving average over `width` samples (odd; narrower towards the ends, so that no phase is shifted).
std::vector<double> moving_average(std::span<const double> signal, std::size_t width);

/// The narrowest odd width, at most `widest`, for which an average leaves `allowed` of a white noise.
std::size_t averaging_width(double noise, double allowed, std::size_t widest);

}  // namespace trunk
