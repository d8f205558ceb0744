#include "clinic/breath_loop.hpp"

#include <algorithm>
#include <cmath>

namespace trunk {
namespace {

constexpr double slope_half_s = 0.05, level_half_width_s = 0.02;
constexpr double turn_part = 0.2, longest_lead_s = 0.3, begin_of_peak = 0.03;

using Curve = std::vector<double>;

// Returns the slope of a straight line through the samples near each one, at least its neighbours. The breath
// repeats: its first and its last sample are the same moment.
Curve slopes(const Curve& time, const Curve& value, double half_s) {
  Curve slope;
  const auto n = static_cast<std::ptrdiff_t>(time.size()) - 1;
  const auto place = [n](std::ptrdiff_t i) { return static_cast<std::size_t>((i + n) % n); };
  const auto time_of = [&](std::ptrdiff_t i) {
    return time[place(i)] + (i < 0 ? -time.back() : i >= n ? time.back() : 0);
  };
  for (std::ptrdiff_t k = 0; k <= n; ++k) {
    std::ptrdiff_t first = k - 1, last = k + 1;
    while (k - first < n / 2 && time_of(k) - time_of(first - 1) <= half_s) --first;
    while (last - k < n / 2 && time_of(last + 1) - time_of(k) <= half_s) ++last;
    const auto count = static_cast<double>(last - first + 1);
    double mean_time = 0, mean_value = 0, covariance = 0, variance = 0;
    for (auto i = first; i <= last; ++i)
      mean_time += time_of(i) / count, mean_value += value[place(i)] / count;
    for (auto i = first; i <= last; ++i) {
      covariance += (time_of(i) - mean_time) * (value[place(i)] - mean_value);
      variance += (time_of(i) - mean_time) * (time_of(i) - mean_time);
    }
    slope.push_back(covariance / variance);
  }
  return slope;
}

// Finds where flow turns at the end of inspiration. => loop.inspiration_s
void find_turn(BreathLoop& loop) {
  const double landmark = loop.inspiration_s, from = (1 - turn_part) * landmark,
               until = landmark + turn_part * (loop.duration_s - landmark);
  const Curve flow =
      slopes(loop.time_s, loop.volume_m3, 0);  // a smooth one turns too early where it falls fast
  double nearest = HUGE_VAL;
  for (std::size_t i = 1; i < loop.time_s.size(); ++i) {
    const double before = flow[i - 1], after = flow[i];
    if (!(before > 0 && after <= 0) || loop.time_s[i] < from || loop.time_s[i - 1] > until) continue;
    const double turn =
        loop.time_s[i - 1] + (loop.time_s[i] - loop.time_s[i - 1]) * before / (before - after);
    if (std::abs(turn - landmark) < std::abs(nearest - landmark)) nearest = turn;
  }
  if (std::isfinite(nearest)) loop.inspiration_s = nearest;
}

// Finds where the flow of the next breath begins. => loop.flow_begins_s
void find_begin(BreathLoop& loop) {
  double peak = 0;
  for (std::size_t i = 0; i < loop.time_s.size() && loop.time_s[i] <= loop.inspiration_s; ++i)
    peak = std::max(peak, loop.flow_m3_s[i]);
  loop.flow_begins_s = loop.duration_s;
  for (std::size_t i = loop.time_s.size(); i-- > 0 && loop.time_s[i] >= loop.duration_s - longest_lead_s;)
    if (loop.flow_m3_s[i] <= begin_of_peak * peak) {
      loop.flow_begins_s = loop.time_s[i];
      return;
    }
}

// Takes pressures from the moment at which flow begins. => curve
void refer(const BreathLoop& loop, Curve& curve) {
  if (curve.empty()) return;
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < curve.size(); ++i)
    if (std::abs(loop.time_s[i] - loop.flow_begins_s) <= level_half_width_s) sum += curve[i], ++count;
  const double level = count > 0 ? sum / count : interpolated(loop.time_s, curve, loop.flow_begins_s);
  for (double& v : curve) v -= level;
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
  loop.flow_m3_s = slopes(loop.time_s, loop.volume_m3, slope_half_s);
  find_turn(loop);
  find_begin(loop);
  for (Curve* curve : {&loop.pleural_Pa, &loop.gastric_Pa, &loop.transdiaphragmatic_Pa, &loop.airway_Pa})
    refer(loop, *curve);
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
      breath.inspiration_s, breath.duration_s, 0, breath.time_s, breath.volume_m3, {}, {}, {}, {}, {}};
  for (const MeasuredChannel& channel : breath.channels)
    if (Curve* curve = pressure_in(loop, channel.kind)) *curve = channel.value;
  finish(loop);
  return loop;
}

BreathLoop loop_of(const MeasuredBreath& breath, std::size_t used) {
  const Breath& b = breath.used[used];
  BreathLoop loop{b.inspiration_s(), b.duration_s(), 0, {}, breath.each_m3[used], {}, {}, {}, {}, {}};
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
