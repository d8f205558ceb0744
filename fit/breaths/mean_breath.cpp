#include "breaths/mean_breath.hpp"

#include <algorithm>
#include <cmath>

#include "breaths/knot_line.hpp"
#include "breaths/mean_channels.hpp"
#include "breaths/mean_of.hpp"
#include "breaths/robust.hpp"
#include "errors/input_error.hpp"
#include "math/median.hpp"

namespace trunk {
namespace {

constexpr double least_sigma = 0.01;  // of the tidal volume

using Breaths = std::vector<Breath>;

void check_usable(const Segmentation& segmentation, int samples) {
  if (!segmentation.calibrated)
    throw InputError({segmentation.source}, "the signal comes from a belt and has arbitrary units", "volumes",
                     "give the tidal volume of its median breath, as in --calibrate-tidal-volume 500 (ml)");
  if (samples >= 3) return;
  throw InputError({segmentation.source}, std::to_string(samples) + " samples per breath asked for",
                   "3 or more", "ask for about 200");
}

MeasuredBreath mean_timing(const Breaths& used) {
  MeasuredBreath mean;
  const auto n = static_cast<double>(used.size());
  for (const auto& breath : used) {
    mean.inspiration_s += breath.inspiration_s() / n;
    mean.duration_s += breath.duration_s() / n;
    mean.pause_s += breath.pause_s / n;
    mean.tidal_volume_m3 += breath.tidal_volume_m3 / n;
  }
  return mean;
}

std::vector<double> even_grid(double end, int samples) {
  std::vector<double> grid;
  for (int i = 0; i + 1 < samples; ++i) grid.push_back(end * i / (samples - 1));
  grid.push_back(end);  // exact, without rounding
  return grid;
}

// Returns the signal of every breath at time t of the mean, [breaths].
std::vector<double> values_at(const Segmentation& segmentation, const std::vector<double>& signal,
                              const Breaths& used, const MeasuredBreath& mean, double t) {
  std::vector<double> values;
  for (const auto& breath : used)
    values.push_back(interpolated(segmentation.time_s, signal, time_in(breath, mean, t)));
  return values;
}

double sigma_at(const Segmentation& segmentation, const Breaths& used, const MeasuredBreath& mean, double t,
                const std::vector<double>& volumes, double noise) {
  const bool given = !segmentation.sigma_m3.empty();
  double sigma = used.size() >= enough_for_deviation ? deviation_of(volumes) : given ? 0 : noise;
  if (given) sigma = std::max(sigma, mean_of(values_at(segmentation, segmentation.sigma_m3, used, mean, t)));
  return std::max(sigma, least_sigma * mean.tidal_volume_m3);
}

MeasuredBreath averaged(const Segmentation& segmentation, const Breaths& used, int samples) {
  MeasuredBreath mean = mean_timing(used);
  mean.time_s = even_grid(mean.duration_s, samples);
  mean.used = used;
  mean.each_m3.resize(used.size());
  const double noise = noise_deviation(segmentation.volume_m3);
  for (const double t : mean.time_s) {
    const auto volumes = values_at(segmentation, segmentation.volume_m3, used, mean, t);
    for (std::size_t b = 0; b < used.size(); ++b) mean.each_m3[b].push_back(volumes[b]);
    mean.volume_m3.push_back(mean_of(volumes));
    mean.sigma_m3.push_back(sigma_at(segmentation, used, mean, t, volumes, noise));
  }
  for (const double sigma : mean.sigma_m3)
    mean.standard_error_m3.push_back(sigma / std::sqrt(static_cast<double>(used.size())));
  // By definition of the base line the volume is 0 there; the samples hold noise.
  mean.volume_m3.front() = mean.volume_m3.back() = 0;
  for (auto& volume : mean.each_m3) volume.front() = volume.back() = 0;
  mean.breaths_used = static_cast<int>(used.size());
  mean.channels = mean_channels(segmentation, mean);
  mean.excursion_m = segmentation.excursion_m;
  mean.window = segmentation.window;
  return mean;
}

/// Cuts pauses that are much longer than usual, such as the one with which a recording ends. To stretch such
/// a breath to the mean duration would make its recoil look faster than it is.
void cut_long_pauses(Breaths& breaths) {
  constexpr double much = 0.1;  // of a breath; our choice
  std::vector<double> pauses, durations;
  for (const Breath& b : breaths) {
    pauses.push_back(b.pause_s);
    durations.push_back(b.duration_s());
  }
  const double usual_s = median(pauses), allowed_s = usual_s + much * median(durations);
  for (Breath& b : breaths)
    if (b.pause_s > allowed_s) {
      b.end_s -= b.pause_s - usual_s;
      b.pause_s = usual_s;
    }
}

}  // namespace

double time_in(const Breath& breath, const MeasuredBreath& mean, double t) {
  if (t <= mean.inspiration_s)
    return breath.onset_s + (breath.peak_s - breath.onset_s) * t / mean.inspiration_s;
  const double part = (t - mean.inspiration_s) / (mean.duration_s - mean.inspiration_s);
  return breath.peak_s + (breath.end_s - breath.peak_s) * part;
}

const MeasuredChannel* MeasuredBreath::channel(ChannelKind kind) const {
  const auto found =
      std::find_if(channels.begin(), channels.end(), [&](const auto& c) { return c.kind == kind; });
  return found == channels.end() ? nullptr : &*found;
}

MeasuredBreath mean_breath(const Segmentation& segmentation, int samples) {
  check_usable(segmentation, samples);
  Breaths kept;
  for (const auto& breath : segmentation.breaths)
    if (breath.kept) kept.push_back(breath);
  if (kept.empty())
    throw InputError({segmentation.source},
                     "none of the " + std::to_string(segmentation.breaths.size()) +
                         " whole breaths can be used, the first because " +
                         segmentation.breaths.front().reason,
                     "one or more", "choose some with --include or give another recording");
  cut_long_pauses(kept);
  MeasuredBreath mean = averaged(segmentation, kept, samples);
  mean.breaths_rejected = static_cast<int>(segmentation.breaths.size() - kept.size());
  return mean;
}

MeasuredBreath single_breath(const Segmentation& segmentation, std::size_t number, int samples) {
  check_usable(segmentation, samples);
  const Breaths& all = segmentation.breaths;
  const auto position = position_of(all, number);
  if (!position)
    throw InputError({segmentation.source}, "there is no breath " + std::to_string(number),
                     std::to_string(all.front().number) + " to " + std::to_string(all.back().number) +
                         ", the whole breaths found",
                     "choose one of them");
  return averaged(segmentation, {all[*position]}, samples);
}

}  // namespace trunk
