#include "structure/mixture.hpp"

#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "search/multistart.hpp"

namespace trunk {
namespace {

/// Returns the part of the variance that belongs to each choice.
std::vector<double> variances(std::span<const Effect> effects, std::span<const Crossing> crossings) {
  std::vector<double> parts;
  for (const Effect& e : effects) parts.push_back(e.variance());
  for (const Crossing& c : crossings)
    for (const std::size_t i : {c.first, c.second}) parts[i] += 0.5 * c.bend * c.bend / 9.0;
  return parts;
}

/// Returns the change at many combinations of choices, in rising order.
std::vector<double> changes(std::span<const Effect> effects, std::span<const Crossing> crossings) {
  constexpr std::size_t points = 4096;
  constexpr unsigned seed = 1;
  const auto n = static_cast<Eigen::Index>(effects.size());
  const LeastSquares cube{{}, Eigen::VectorXd::Constant(n, -1.0), Eigen::VectorXd::Ones(n)};
  std::vector<double> sums;
  for (const Eigen::VectorXd& point : sobol_starts(cube, points, seed)) {
    const double* place = point.data();
    double sum = 0.0;
    for (std::size_t i = 0; i < effects.size(); ++i) sum += effects[i].at(place[i]);
    for (const Crossing& c : crossings) sum += c.bend * place[c.first] * place[c.second];
    sums.push_back(sum);
  }
  std::sort(sums.begin(), sums.end());
  return sums;
}

}  // namespace

double Effect::variance() const noexcept {
  if (one_of_two) return 0.25 * high * high;
  const double slope = 0.5 * (high - low), bend = 0.5 * (high + low);
  return slope * slope / 3.0 + bend * bend * 4.0 / 45.0;
}

double Effect::at(double place) const noexcept {
  if (one_of_two) return place < 0.0 ? 0.0 : high;
  return 0.5 * place * (high - low + place * (high + low));
}

Mixture mixture_of(std::span<const Effect> effects, std::span<const Crossing> crossings) {
  constexpr double no_share = std::numeric_limits<double>::quiet_NaN();
  Mixture m{0.0, 0.0, variances(effects, crossings)};
  const double variance = std::accumulate(m.shares.begin(), m.shares.end(), 0.0);
  for (double& share : m.shares) share = variance > 0.0 ? share / variance : no_share;
  if (!std::isfinite(variance)) m.lower95 = m.upper95 = no_share;
  if (!(variance > 0.0)) return m;
  const std::vector<double> sorted = changes(effects, crossings);
  m.lower95 = gsl_stats_quantile_from_sorted_data(sorted.data(), 1, sorted.size(), 0.025);
  m.upper95 = gsl_stats_quantile_from_sorted_data(sorted.data(), 1, sorted.size(), 0.975);
  return m;
}

}  // namespace trunk
