#include "expiration/expired_energy.hpp"

#include <algorithm>
#include <cmath>

#include "math/median.hpp"

namespace trunk {
namespace {

constexpr double late_from = 0.85, late_until = 0.93;  // of expiration

// Sums over breaths at each sample of expiration; one breath can be taken out of them.
struct FlowSums {
  std::vector<double> time_s;                // [samples] from the end of inspiration
  std::vector<std::vector<double>> flow;     // [breaths][samples]
  std::vector<double> sum, sum_of_squares;   // [samples]
  double tidal_volume_m3 = 0, expiration_s;  // sum; mean
};

FlowSums flow_sums(const MeasuredBreath& breath) {
  FlowSums sums;
  const double step = breath.time_s[1] - breath.time_s[0];
  const auto first = static_cast<std::size_t>(
      std::upper_bound(breath.time_s.begin(), breath.time_s.end(), breath.inspiration_s) -
      breath.time_s.begin());
  for (std::size_t i = first; i < breath.time_s.size(); ++i)
    sums.time_s.push_back(breath.time_s[i] - breath.inspiration_s);
  sums.sum.assign(sums.time_s.size(), 0);
  sums.sum_of_squares = sums.sum;
  sums.expiration_s = breath.duration_s - breath.inspiration_s;
  for (std::size_t b = 0; b < breath.each_m3.size(); ++b) {
    const std::vector<double> flow = flow_of(breath.each_m3[b], step);
    sums.flow.emplace_back(flow.begin() + static_cast<std::ptrdiff_t>(first), flow.end());
    sums.tidal_volume_m3 += breath.used[b].tidal_volume_m3;
    for (std::size_t i = 0; i < sums.sum.size(); ++i) {
      sums.sum[i] += sums.flow[b][i];
      sums.sum_of_squares[i] += sums.flow[b][i] * sums.flow[b][i];
    }
  }
  return sums;
}

// Returns the energy of all breaths, or of all but the one that is left out.
ExpiredEnergy energy_of(const FlowSums& sums, const MeasuredBreath& breath, std::size_t left_out) {
  const bool all = left_out >= sums.flow.size();
  const auto n = static_cast<double>(sums.flow.size() - (all ? 0 : 1));
  std::vector<double> late;
  ExpiredEnergy energy;
  // Trapezia; the flow is 0 at the end of inspiration.
  double before = 0, before_s = 0;
  for (std::size_t i = 0; i < sums.time_s.size(); ++i) {
    const double own = all ? 0 : sums.flow[left_out][i];
    const double sum = sums.sum[i] - own, squares = sums.sum_of_squares[i] - own * own;
    const double squared = n > 1 ? (sum * sum - squares) / (n * (n - 1)) : squares;
    energy.squared_flow += 0.5 * (before + squared) * (sums.time_s[i] - before_s);
    before = squared, before_s = sums.time_s[i];
    const double part = before_s / sums.expiration_s;
    if (part >= late_from && part <= late_until) late.push_back(-sum / n);
  }
  energy.squared_flow = std::max(energy.squared_flow, 0.0);
  energy.late_flow_m3_s = std::max(median(std::move(late)), 0.0);
  energy.expiration_s = sums.expiration_s;
  energy.tidal_volume_m3 = (sums.tidal_volume_m3 - (all ? 0 : breath.used[left_out].tidal_volume_m3)) / n;
  return energy;
}

}  // namespace

std::vector<double> flow_of(const std::vector<double>& volume, double step_s, double reach_s) {
  const std::size_t n = volume.size();
  const auto reach = static_cast<std::size_t>(std::max(1.0, std::round(reach_s / step_s)));
  std::vector<double> flow(n, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    // The window stays symmetric, so that curvature moves nothing; the first and last sample have one side.
    const std::size_t half = std::min({reach, i, n - 1 - i});
    const std::size_t from = half > 0 ? i - half : i == 0 ? 0 : i - 1, until = half > 0 ? i + half : from + 1;
    const double middle = 0.5 * static_cast<double>(from + until);
    double product = 0, squares = 0;
    for (std::size_t k = from; k <= until && k < n; ++k) {
      const double t = static_cast<double>(k) - middle;
      product += t * volume[k];
      squares += t * t;
    }
    flow[i] = squares > 0 ? product / (squares * step_s) : 0;
  }
  return flow;
}

ExpiredEnergy expired_energy(const MeasuredBreath& breath) {
  return energy_of(flow_sums(breath), breath, breath.each_m3.size());
}

std::vector<ExpiredEnergy> expired_energy_without_each(const MeasuredBreath& breath) {
  std::vector<ExpiredEnergy> energies;
  if (breath.each_m3.size() < 3) return energies;
  const FlowSums sums = flow_sums(breath);
  for (std::size_t b = 0; b < breath.each_m3.size(); ++b) energies.push_back(energy_of(sums, breath, b));
  return energies;
}

}  // namespace trunk
