#include "expiration/passive_expiration.hpp"

#include <gsl/gsl_fit.h>
#include <gsl/gsl_statistics.h>

#include <algorithm>
#include <cmath>

#include "expiration/expired_energy.hpp"

namespace trunk {
namespace {

constexpr double least_r_squared = 0.98, largest_offset = 0.2, end_of_fall = 0.05;
constexpr double before_late = 0.85;  // of expiration: its end may jump to 0
constexpr std::size_t fewest_samples = 5;

}  // namespace

PassiveExpiration passive_expiration(const MeasuredBreath& breath) {
  const std::vector<double>&time = breath.time_s, &volume = breath.volume_m3;
  const std::vector<double> rate = flow_of(volume, time[1] - time[0]);
  const double late_s = breath.inspiration_s + before_late * (breath.duration_s - breath.inspiration_s);
  const auto late = std::lower_bound(time.begin(), time.end(), late_s) - time.begin();
  const auto peak = std::min_element(rate.begin(), rate.begin() + late) - rate.begin();
  std::vector<double> left, flow;
  for (auto i = static_cast<std::size_t>(peak); i < volume.size(); ++i) {
    if (volume[i] < end_of_fall * breath.tidal_volume_m3) break;
    left.push_back(volume[i]);
    flow.push_back(-rate[i]);
  }
  PassiveExpiration line;
  if (left.size() < fewest_samples) return line;
  double offset = 0, unused[4];
  gsl_fit_linear(flow.data(), 1, left.data(), 1, left.size(), &offset, &line.recoil_s, &unused[0], &unused[1],
                 &unused[2], &unused[3]);
  line.r_squared = std::pow(gsl_stats_correlation(flow.data(), 1, left.data(), 1, left.size()), 2);
  line.offset_of_tidal_volume = offset / breath.tidal_volume_m3;
  line.straight = line.recoil_s > 0 && line.r_squared >= least_r_squared &&
                  std::abs(line.offset_of_tidal_volume) <= largest_offset;
  return line;
}

}  // namespace trunk
