#include "breaths/robust.hpp"

#include <algorithm>
#include <cmath>

#include "math/median.hpp"

namespace trunk {

double noise_deviation(std::span<const double> signal) {
  std::vector<double> differences;
  for (std::size_t i = 4; i < signal.size(); ++i)
    differences.push_back(
        std::abs(signal[i - 4] - 4 * signal[i - 3] + 6 * signal[i - 2] - 4 * signal[i - 1] + signal[i]));
  return median(std::move(differences)) / (0.6745 * std::sqrt(70.0));
}

double quantile(std::vector<double> values, double part) {
  const auto nth =
      values.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), nth, values.end());
  return *nth;
}

std::vector<double> moving_average(std::span<const double> signal, std::size_t width) {
  if (width <= 1) return {signal.begin(), signal.end()};
  const std::size_t n = signal.size();
  std::vector<double> sum(n + 1, 0.0), average(n);
  for (std::size_t i = 0; i < n; ++i) sum[i + 1] = sum[i] + signal[i];
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t half = std::min({width / 2, i, n - 1 - i});
    average[i] = (sum[i + half + 1] - sum[i - half]) / static_cast<double>(2 * half + 1);
  }
  return average;
}

std::size_t averaging_width(double noise, double allowed, std::size_t widest) {
  const double needed = allowed > 0 ? std::pow(noise / allowed, 2) : 1;
  const double width =
      std::clamp(std::ceil(needed), 1.0, static_cast<double>(std::max<std::size_t>(widest, 1)));
  const auto samples = static_cast<std::size_t>(width);
  if (samples % 2 == 1) return samples;
  return samples + 1 <= widest ? samples + 1 : samples - 1;
}

}  // namespace trunk
