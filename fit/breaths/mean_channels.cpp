#include "breaths/mean_channels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "breaths/heartbeat.hpp"
#include "breaths/mean_of.hpp"
#include "breaths/robust.hpp"
#include "errors/input_error.hpp"
#include "math/median.hpp"
#include "math/units.hpp"
#include "text/message_text.hpp"

namespace trunk {
namespace {

constexpr double level_half_s = 0.02, envelope_s = 0.1;
constexpr double least_sigma_of_swing = 0.01;
constexpr double both_signs = 0.2;  // of the largest value: an EMG with both signs is raw
constexpr std::size_t enough_for_swallows = 4;
constexpr double swallow_of_median = 4, swallow_of_swing = 1;

using Curve = std::vector<double>;

double step_of(const Curve& time) {
  return (time.back() - time.front()) / static_cast<double>(time.size() - 1);
}

// Returns the envelope of a raw EMG, or an EMG that is one already. A gap of the channel stays one.
Curve envelope(const Segmentation& s, const Curve& emg, std::vector<std::string>& notes) {
  Curve finite;
  for (const double v : emg)
    if (std::isfinite(v)) finite.push_back(v);
  const auto [low, high] = std::minmax_element(finite.begin(), finite.end());
  if (*low > -both_signs * *high) return emg;
  const double level = median(std::move(finite));
  Curve rectified;
  for (const double v : emg) rectified.push_back(std::isfinite(v) ? std::abs(v - level) : 0);
  const auto width = static_cast<std::size_t>(std::max(envelope_s / step_of(s.time_s), 1.0)) | 1;
  Curve smooth = moving_average(rectified, width);
  for (std::size_t i = 0; i < emg.size(); ++i)
    if (!std::isfinite(emg[i])) smooth[i] = NAN;
  notes.push_back(
      fmt::format("the EMG takes both signs: it is made positive and averaged over {} s", envelope_s));
  return smooth;
}

double level_at(const Segmentation& s, const Curve& signal, double t) {
  const auto begin = std::lower_bound(s.time_s.begin(), s.time_s.end(), t - level_half_s) - s.time_s.begin();
  double sum = 0;
  std::size_t count = 0;
  for (auto i = static_cast<std::size_t>(begin); i < s.time_s.size() && s.time_s[i] <= t + level_half_s; ++i)
    sum += signal[i], ++count;
  return count > 0 ? sum / static_cast<double>(count) : interpolated(s.time_s, signal, t);
}

// Returns a breath of the signal, without the line between its ends if `changes`. => the level at its onset
Curve breath_of(const Segmentation& s, const Curve& signal, const Breath& b, const MeasuredBreath& mean,
                bool changes, double& onset_level) {
  onset_level = level_at(s, signal, b.onset_s);
  const double slope = (level_at(s, signal, b.end_s) - onset_level) / b.duration_s();
  Curve curve;
  for (const double t : mean.time_s) {
    const double at = time_in(b, mean, t);
    curve.push_back(interpolated(s.time_s, signal, at) -
                    (changes ? onset_level + slope * (at - b.onset_s) : 0));
  }
  return curve;
}

Curve median_curve(const std::vector<Curve>& each) {
  Curve middle;
  for (std::size_t k = 0; k < each.front().size(); ++k) {
    Curve at;
    for (const Curve& curve : each) at.push_back(curve[k]);
    middle.push_back(median(std::move(at)));
  }
  return middle;
}

double swing_of(const Curve& curve) {
  const auto [low, high] = std::minmax_element(curve.begin(), curve.end());
  return *high - *low;
}

// Returns which curves hold a swallow. `sign`: that of the spike.
std::vector<bool> swallows(const std::vector<Curve>& each, double sign) {
  std::vector<bool> found(each.size(), false);
  if (each.size() < enough_for_swallows) return found;
  const Curve usual = median_curve(each);
  Curve rises;
  for (const Curve& curve : each) {
    double most = 0;
    for (std::size_t k = 0; k < usual.size(); ++k) most = std::max(most, sign * (curve[k] - usual[k]));
    rises.push_back(most);
  }
  const double limit = std::max(swallow_of_median * median(rises), swallow_of_swing * swing_of(usual));
  for (std::size_t b = 0; b < each.size(); ++b) found[b] = rises[b] > limit;
  return found;
}

// Returns "breath 3" or "breaths 3, 7": the numbers that the user sees.
std::string numbers_of(const MeasuredBreath& mean, const std::vector<std::size_t>& which) {
  std::string list = which.size() == 1 ? "breath" : "breaths";
  for (std::size_t k = 0; k < which.size(); ++k)
    list += fmt::format("{}{}", k > 0 ? ", " : " ", mean.used[which[k]].number);
  return list;
}

// Leaves out breaths that are not whole or hold a swallow. => channel
void choose_breaths(const MeasuredBreath& mean, MeasuredChannel& channel) {
  const auto leave_out = [&](auto out, const std::string& why) {
    std::vector<std::size_t> gone, kept;
    std::vector<Curve> curves;
    for (std::size_t b = 0; b < channel.each.size(); ++b) {
      (out(b) ? gone : kept).push_back(channel.breaths[b]);
      if (!out(b)) curves.push_back(std::move(channel.each[b]));
    }
    if (!gone.empty())
      channel.notes.push_back(fmt::format("{} do{} not count for the {}: {}", numbers_of(mean, gone),
                                          gone.size() == 1 ? "es" : "", words_of(channel.kind), why));
    channel.breaths = std::move(kept);
    channel.each = std::move(curves);
  };
  std::vector<bool> broken;
  for (const Curve& curve : channel.each)
    broken.push_back(!std::all_of(curve.begin(), curve.end(), [](double v) { return std::isfinite(v); }));
  leave_out([&](std::size_t b) { return broken[b]; }, "the column has a gap there");
  const double sign = channel.kind == ChannelKind::pleural              ? 1
                      : channel.kind == ChannelKind::transdiaphragmatic ? -1
                                                                        : 0;
  if (sign == 0) return;
  const std::vector<bool> swallowed = swallows(channel.each, sign);
  leave_out([&](std::size_t b) { return swallowed[b]; }, "a spike as of a swallow");
}

void average(double noise, MeasuredChannel& channel) {
  const std::size_t samples = channel.each.front().size();
  const auto n = static_cast<double>(channel.each.size());
  for (std::size_t k = 0; k < samples; ++k) {
    Curve at;
    for (const Curve& curve : channel.each) at.push_back(curve[k]);
    channel.value.push_back(mean_of(at));
    channel.sigma.push_back(at.size() >= enough_for_deviation ? deviation_of(at) : noise);
  }
  const double least = std::max(least_sigma_of_swing * swing_of(channel.value), 1e-12);
  for (double& sigma : channel.sigma) {
    sigma = std::max(sigma, least);
    channel.standard_error.push_back(sigma / std::sqrt(n));
  }
}

double noise_of(const Curve& signal) {
  Curve finite;
  for (const double v : signal)
    if (std::isfinite(v)) finite.push_back(v);
  return noise_deviation(finite);
}

void start_at_zero(MeasuredChannel& channel) {
  channel.end_expiratory = *std::min_element(channel.value.begin(), channel.value.end());
  for (double& v : channel.value) v -= channel.end_expiratory;
  for (Curve& curve : channel.each)
    for (double& v : curve) v -= channel.end_expiratory;
}

MeasuredChannel mean_channel(const Segmentation& s, const TraceChannel& trace, const MeasuredBreath& mean) {
  const bool emg = trace.kind == ChannelKind::emg;
  MeasuredChannel channel;
  channel.kind = trace.kind, channel.column = trace.column, channel.unit = trace.unit;
  const Curve signal = emg ? envelope(s, trace.value, channel.notes) : trace.value;
  Curve levels;
  for (std::size_t b = 0; b < mean.used.size(); ++b) {
    channel.breaths.push_back(b);
    levels.push_back(0);
    channel.each.push_back(breath_of(s, signal, mean.used[b], mean, !emg, levels.back()));
  }
  choose_breaths(mean, channel);
  if (channel.each.empty())
    throw InputError(
        {s.source}, fmt::format("column {} has no whole breath without a gap", excerpt(trace.column)),
        "one or more", fmt::format("correct it, or leave it out with --{} none", option_of(trace.kind)));
  average(noise_of(signal), channel);
  if (emg)
    start_at_zero(channel);
  else
    for (const std::size_t b : channel.breaths)
      channel.end_expiratory += levels[b] / static_cast<double>(channel.breaths.size());
  if (trace.kind == ChannelKind::pleural)
    if (const auto beat = heartbeat(s, signal, channel, mean))
      channel.notes.push_back(fmt::format(
          "the heart shows in the oesophageal pressure, {:.0f} times a minute and by about {:.2g} cmH2O "
          "(standard "
          "deviation); nothing is filtered, and the mean of {} breaths keeps about {:.2g} cmH2O of it",
          s_per_min / beat->period_s, beat->deviation / Pa_per_cmH2O, channel.each.size(),
          beat->deviation / Pa_per_cmH2O / std::sqrt(static_cast<double>(channel.each.size()))));
  return channel;
}

}  // namespace

std::vector<MeasuredChannel> mean_channels(const Segmentation& segmentation, const MeasuredBreath& mean) {
  std::vector<MeasuredChannel> channels;
  Mistakes mistakes;
  for (const TraceChannel& trace : segmentation.channels)
    mistakes.gather([&] { channels.push_back(mean_channel(segmentation, trace, mean)); });
  mistakes.settle();
  return channels;
}

}  // namespace trunk
