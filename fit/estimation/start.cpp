#include "estimation/start.hpp"

#include <algorithm>
#include <cmath>

#include "problem/free_parameters.hpp"

namespace trunk {

namespace {

constexpr double emg_range = 0.4;  // of the activation: an EMG is followed from the start
constexpr double first_share = 0.05, independent_samples = 20.0, excursion_error_m = 2e-3;

/// Returns the largest change of a course in time.
double range_of(const std::vector<double>& value) {
  const auto [low, high] = std::minmax_element(value.begin(), value.end());
  return *high - *low;
}

}  // namespace

MeasuredCurve measured_curve_of(const MeasuredBreath& breath, bool weighted) {
  MeasuredCurve measured{
      breath.time_s, breath.volume_m3, weighted ? breath.sigma_m3 : std::vector<double>(), {}};
  const bool has_both =
      breath.channel(ChannelKind::pleural) != nullptr && breath.channel(ChannelKind::gastric) != nullptr;
  for (const MeasuredChannel& channel : breath.channels) {
    if (channel.kind == ChannelKind::airway) continue;  // it drives the model
    if (channel.kind == ChannelKind::transdiaphragmatic && has_both) continue;
    const auto n = static_cast<double>(channel.value.size());
    const double range = channel.kind == ChannelKind::emg ? emg_range : range_of(channel.value);
    measured.beside.push_back({channel.kind, channel.value,
                               first_share * range * std::sqrt(std::max(1.0, n / independent_samples))});
  }
  if (breath.excursion_m)
    measured.beside.push_back({ChannelKind::excursion, {*breath.excursion_m}, excursion_error_m});
  return measured;
}

std::vector<std::vector<double>> breaths_of(const MeasuredBreath& breath, const MeasuredCurve& measured) {
  std::vector<std::vector<double>> all = breath.each_m3;
  const Eigen::VectorXd mean = values_of(measured);
  const std::vector<Block> blocks = blocks_of(measured);
  for (std::size_t b = 1; b < blocks.size(); ++b) {
    const MeasuredObservable& o = measured.beside[b - 1];
    for (std::vector<double>& values : all)
      values.insert(values.end(), mean.data() + blocks[b].first,
                    mean.data() + blocks[b].first + blocks[b].count);
    const MeasuredChannel* channel = breath.channel(o.kind);
    if (o.is_number() || o.kind == ChannelKind::emg || channel == nullptr) continue;
    const double share = static_cast<double>(all.size()) / static_cast<double>(channel->breaths.size());
    for (std::size_t k = 0; k < channel->breaths.size(); ++k)
      for (std::size_t i = 0; i < o.value.size(); ++i)
        all[channel->breaths[k]][static_cast<std::size_t>(blocks[b].first) + i] +=
            share * (channel->each[k][i] - o.value[i]);
  }
  return all;
}

BreathActivation<double> activation_from_landmarks(const MeasuredBreath& breath) {
  const double expiration_s = breath.duration_s - breath.inspiration_s;
  BreathActivation<double> a;
  a.rise_s = breath.inspiration_s;
  a.fast_fall_s = 0.25 * expiration_s;
  a.slow_fall_s = 0.5 * expiration_s;
  for (const FreeParameter& p : free_parameters()) {  // a fit must start within its bounds
    if (p.group != FreeParameter::Group::timing) continue;
    Candidate c{{}, a};
    p.field(c) = std::clamp(p.field(c), p.lower, p.upper);
    a = c.activation;
  }
  return a;
}

}  // namespace trunk
