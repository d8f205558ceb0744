#include "uncertainty/bootstrap.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace trunk {
namespace {

int block_length(const Noise& noise, Eigen::Index samples) {
  const double wanted = 3.0 / (1.0 - noise.rho);
  return static_cast<int>(std::clamp(wanted, 5.0, std::max(5.0, 0.25 * static_cast<double>(samples))));
}

/// Returns residuals composed of pieces with random beginnings.
Eigen::VectorXd resampled(const Eigen::VectorXd& residuals, Eigen::Index block, std::mt19937_64& engine) {
  const Eigen::Index n = residuals.size();
  Eigen::VectorXd result(n);
  for (Eigen::Index at = 0; at < n; at += block) {
    const auto first = static_cast<Eigen::Index>(engine() % static_cast<std::uint64_t>(n - block + 1));
    const Eigen::Index length = std::min(block, n - at);
    result.segment(at, length) = residuals.segment(first, length);
  }
  return result;
}

Interval middle95(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const auto at = [&](double part) {
    const double place = part * static_cast<double>(values.size() - 1);
    const auto k = static_cast<std::size_t>(place);
    const double rest = place - static_cast<double>(k);
    return values[k] + rest * (values[std::min(k + 1, values.size() - 1)] - values[k]);
  };
  return {at(0.025), at(0.975)};
}

}  // namespace

Bootstrap bootstrap(Objective& objective, const LocalFit& fit, int repeats, unsigned seed) {
  const SearchSpace& space = objective.space();
  Bootstrap result{repeats, block_length(fit.noise, fit.blocks.front().count), {}, {}};
  // The residuals are smaller than the noise, because the fit followed part of it.
  std::vector<Eigen::VectorXd> centred;
  for (std::size_t b = 0; b < fit.blocks.size(); ++b) {
    const Eigen::VectorXd own = fit.residuals.segment(fit.blocks[b].first, fit.blocks[b].count);
    const double inflate = fit.noises[b].white_deviation /
                           std::max(std::sqrt(own.squaredNorm() / static_cast<double>(own.size())), 1e-300);
    centred.emplace_back(inflate * (own.array() - own.mean()).matrix());
  }
  std::mt19937_64 engine(seed);
  std::vector<Eigen::VectorXd> shift;
  // Residuals are model - measured. Data with other noise e have residuals that are smaller by e - (old
  // noise).
  for (int k = 0; k < repeats; ++k) {
    shift.push_back(fit.residuals);
    for (std::size_t b = 0; b < fit.blocks.size(); ++b)
      shift.back().segment(fit.blocks[b].first, fit.blocks[b].count) += resampled(
          centred[b],
          std::min<Eigen::Index>(block_length(fit.noises[b], fit.blocks[b].count), fit.blocks[b].count),
          engine);
  }
  const std::vector<Refit> fits =
      refits(objective.problem(), fit, Eigen::MatrixXd::Identity(fit.x.size(), fit.x.size()),
             std::vector<Eigen::VectorXd>(static_cast<std::size_t>(repeats), fit.x), shift, 3);
  std::vector<double> ratios;
  for (std::size_t i = 0; i < space.asked_for(); ++i) {
    std::vector<double> values;
    for (const Refit& f : fits) values.push_back(value_of(space.parameter(i), space.decode(f.x)));
    result.interval95.push_back(middle95(values));
    if (space.is_ratio(i))
      for (const Refit& f : fits) ratios.push_back(std::exp(f.x[static_cast<Eigen::Index>(i)]));
  }
  if (!ratios.empty()) result.ratio95 = middle95(ratios);
  return result;
}

}  // namespace trunk
