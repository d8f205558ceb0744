#include "clinic/breath_loop.hpp"

#include <algorithm>

namespace trunk {
namespace {

constexpr double slope_half_s = 0.05;

using Curve = std::vector<double>;

// Returns the slope of a straight line through the samples near each one, at least its neighbours.
Curve slopes(const Curve& time, const Curve& value) {
  Curve slope;
  const std::size_t n = time.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t first = k > 0 ? k - 1 : 0, last = std::min(k + 1, n - 1);
    while (first > 0 && time[k] - time[first - 1] <= slope_half_s) --first;
    while (last + 1 < n && time[last + 1] - time[k] <= slope_half_s) ++last;
    const auto count = static_cast<double>(last - first + 1);
    double mean_time = 0, mean_value = 0, covariance = 0, variance = 0;
    for (std::size_t i = first; i <= last; ++i) mean_time += time[i] / count, mean_value += value[i] / count;
    for (std::size_t i = first; i <= last; ++i) {
      covariance += (time[i] - mean_time) * (value[i] - mean_value);
      variance += (time[i] - mean_time) * (time[i] - mean_time);
    }
    slope.push_back(covariance / variance);
  }
  return slope;
}

Curve sum(const Curve& a, double factor, const Curve& b) {
  Curve result;
  for (std::size_t i = 0; i < a.size(); ++i) result.push_back(a[i] + factor * b[i]);
  return result;
}

// Two of the three pressures give the third. => loop
void complete(BreathLoop& loop) {
  Curve &pleural = loop.pleural_Pa, &gastric = loop.gastric_Pa, &across = loop.transdiaphragmatic_Pa;
  if (across.empty() && !pleural.empty() && !gastric.empty()) across = sum(gastric, -1, pleural);
  if (gastric.empty() && !pleural.empty() && !across.empty()) gastric = sum(across, 1, pleural);
  if (pleural.empty() && !gastric.empty() && !across.empty()) pleural = sum(gastric, -1, across);
}

void finish(BreathLoop& loop) {
  loop.flow_m3_s = slopes(loop.time_s, loop.volume_m3);
  complete(loop);
}

Curve* pressure_in(BreathLoop& loop, ChannelKind kind) {
  switch (kind) {
    case ChannelKind::pleural:
      return &loop.pleural_Pa;
    case ChannelKind::gastric:
      return &loop.gastric_Pa;
    case ChannelKind::transdiaphragmatic:
      return &loop.transdiaphragmatic_Pa;
    case ChannelKind::airway:
      return &loop.airway_Pa;
    default:
      return nullptr;
  }
}

// Returns the integral of `value` over `along`, by trapezia, from one time to another.
double integral(const BreathLoop& loop, const Curve& value, const Curve& along, double from, double until) {
  const auto at = [&](const Curve& curve, double t) { return interpolated(loop.time_s, curve, t); };
  double area = 0, last_value = at(value, from), last_along = at(along, from);
  const auto add = [&](double v, double a) {
    area += 0.5 * (last_value + v) * (a - last_along);
    last_value = v, last_along = a;
  };
  for (std::size_t i = 0; i < loop.time_s.size(); ++i)
    if (loop.time_s[i] > from && loop.time_s[i] < until) add(value[i], along[i]);
  add(at(value, until), at(along, until));
  return area;
}

}  // namespace

double BreathLoop::tidal_volume_m3() const {
  return at_end_inspiration(*this, volume_m3);
}

Curve BreathLoop::transpulmonary_Pa() const {
  const Curve none(pleural_Pa.size(), 0.0);
  return sum(airway_Pa.empty() ? none : airway_Pa, -1, pleural_Pa);
}

BreathLoop mean_loop(const MeasuredBreath& breath) {
  BreathLoop loop{
      breath.inspiration_s, breath.duration_s, breath.time_s, breath.volume_m3, {}, {}, {}, {}, {}};
  for (const MeasuredChannel& channel : breath.channels)
    if (Curve* curve = pressure_in(loop, channel.kind)) *curve = channel.value;
  finish(loop);
  return loop;
}

BreathLoop loop_of(const MeasuredBreath& breath, std::size_t used) {
  const Breath& b = breath.used[used];
  BreathLoop loop{b.inspiration_s(), b.duration_s(), {}, breath.each_m3[used], {}, {}, {}, {}, {}};
  for (const double t : breath.time_s) loop.time_s.push_back(time_in(b, breath, t) - b.onset_s);
  for (const MeasuredChannel& channel : breath.channels) {
    const auto at = std::find(channel.breaths.begin(), channel.breaths.end(), used);
    Curve* curve = pressure_in(loop, channel.kind);
    if (curve != nullptr && at != channel.breaths.end())
      *curve = channel.each[static_cast<std::size_t>(at - channel.breaths.begin())];
  }
  finish(loop);
  return loop;
}

double over_inspiration(const BreathLoop& loop, const Curve& values) {
  return integral(loop, values, loop.time_s, 0, loop.inspiration_s);
}

double over_inspired_volume(const BreathLoop& loop, const Curve& values) {
  return integral(loop, values, loop.volume_m3, 0, loop.inspiration_s);
}

double over_expired_volume(const BreathLoop& loop, const Curve& values) {
  return -integral(loop, values, loop.volume_m3, loop.inspiration_s, loop.duration_s);
}

double at_end_inspiration(const BreathLoop& loop, const Curve& values) {
  return interpolated(loop.time_s, values, loop.inspiration_s);
}

}  // namespace trunk
