#include "breaths/heart_ripple.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "math/median.hpp"

namespace trunk {
namespace {

constexpr std::size_t fewest_breaths = 5, steps_per_breath = 100, steps_per_phase = 60;
constexpr double slowest_hz = 0.6, fastest_hz = 3.5, above_breathing = 2.2, frequency_step_hz = 0.04;
constexpr double spectrum_s = 12, beats_followed = 4;
constexpr double stands_out = 8, least_amplitude = 0.004, most_amplitude = 0.1;
constexpr std::size_t lines_nearby = 15;  // frequencies on either side
constexpr int harmonics = 3, passes = 8;

using Curve = std::vector<double>;
using Samples = std::span<const double>;
using Phasor = std::complex<double>;

double hann(double part) {
  return 0.5 * (1 + std::cos(std::numbers::pi * part));
}

// What the volume has beside its mean breath, on an even grid.
class Remainder {
 public:
  Remainder(Samples time, Samples volume, Samples quiet, const Landmarks& marks, double drift)
      : time_(time), marks_(&marks), drift_(drift) {
    const Curve& rest_s = marks.rest.time;
    Curve durations;
    for (std::size_t b = 0; b + 1 < rest_s.size(); ++b) durations.push_back(rest_s[b + 1] - rest_s[b]);
    const double usual_s = median(durations), usual = median(marks.tidal_volume);
    period_s = usual_s, tidal_volume = usual;
    const auto is_usual = [](double found, double middle) {
      return found > middle / 2 && found < middle * 2;
    };
    for (std::size_t b = 0; b < durations.size(); ++b)
      if (is_usual(durations[b], usual_s) && is_usual(marks.tidal_volume[b], usual)) breaths_.push_back(b);
    step_s = usual_s / steps_per_breath;
    if (breaths_.size() < fewest_breaths) return;
    const Curve mean = mean_breath_curve(quiet);
    value.assign(static_cast<std::size_t>((time.back() - time.front()) / step_s) + 1, 0);
    known.assign(value.size(), 0);
    for (std::size_t b = 0; b < durations.size(); ++b)  // what a shallow one has of the mean is little
      if (marks.tidal_volume[b] < 2 * usual) subtract(b, volume, mean);
  }

  bool empty() const { return value.empty(); }
  double time_at(std::size_t i) const { return time_.front() + step_s * static_cast<double>(i); }

  double step_s = 0, period_s = 0, tidal_volume = 0;
  Curve value, known;  ///< [steps]; known is 1 in breaths, else 0

 private:
  // Phase 0 to 1 is inspiration, 1 to 2 is expiration.
  double time_of(std::size_t b, double phase) const {
    const double onset = marks_->rest.time[b], peak = marks_->peak_s[b], end = marks_->rest.time[b + 1];
    return phase < 1 ? onset + phase * (peak - onset) : peak + (phase - 1) * (end - peak);
  }
  double phase_of(std::size_t b, double t) const {
    const double onset = marks_->rest.time[b], peak = marks_->peak_s[b], end = marks_->rest.time[b + 1];
    return t < peak ? (t - onset) / (peak - onset) : 1 + (t - peak) / (end - peak);
  }
  double level(Samples volume, double t) const {
    return interpolated(time_, volume, t) - marks_->rest(t, drift_);
  }

  Curve mean_breath_curve(Samples quiet) const {
    Curve mean(2 * steps_per_phase + 1, 0);
    for (std::size_t k = 0; k < mean.size(); ++k)
      for (const std::size_t b : breaths_)
        mean[k] += level(quiet, time_of(b, static_cast<double>(k) / steps_per_phase)) /
                   marks_->tidal_volume[b] / static_cast<double>(breaths_.size());
    return mean;
  }

  void subtract(std::size_t b, Samples volume, const Curve& mean) {
    const double onset = marks_->rest.time[b], end = marks_->rest.time[b + 1];
    auto i = static_cast<std::size_t>(std::max(std::ceil((onset - time_.front()) / step_s), 0.0));
    for (; i < value.size() && time_at(i) < end; ++i) {
      const double t = time_at(i), at = phase_of(b, t) * steps_per_phase;
      const auto k = std::min(static_cast<std::size_t>(at), mean.size() - 2);
      const double part = at - static_cast<double>(k);
      value[i] = level(volume, t) - marks_->tidal_volume[b] * ((1 - part) * mean[k] + part * mean[k + 1]);
      known[i] = 1;
    }
  }

  Samples time_;
  const Landmarks* marks_;
  double drift_;
  std::vector<std::size_t> breaths_;
};

// Returns the sum of the remainder times a wave, over `half` steps on either side of a step, weighted. => the
// sum of weights
Phasor demodulated(const Remainder& r, std::size_t centre, std::size_t half, double hz, double& weight) {
  Phasor sum = 0;
  weight = 0;
  const Phasor turn = std::polar(1.0, -2 * std::numbers::pi * hz * r.step_s);
  const std::size_t first = centre > half ? centre - half : 0;
  Phasor wave = std::polar(1.0, -2 * std::numbers::pi * hz * r.time_at(first));
  for (std::size_t i = first; i < std::min(centre + half, r.value.size()); ++i, wave *= turn) {
    const double w =
        r.known[i] * hann((static_cast<double>(i) - static_cast<double>(centre)) / static_cast<double>(half));
    sum += w * r.value[i] * wave;
    weight += w;
  }
  return sum;
}

struct Spectrum {
  Curve hz, power;  ///< of the change of the remainder, which is white for the noise of a flow

  // How far the power at a step is above the median lines_nearby.
  double prominence(std::size_t i) const {
    const std::size_t first = i > lines_nearby ? i - lines_nearby : 0,
                      end = std::min(i + lines_nearby + 1, power.size());
    const double background = median({power.begin() + static_cast<std::ptrdiff_t>(first),
                                      power.begin() + static_cast<std::ptrdiff_t>(end)});
    return background > 0 ? power[i] / background : 0;
  }
  // Returns the frequency of the line that stands out most.
  std::optional<double> highest_line() const {
    std::size_t top = 0;
    double most = stands_out;
    for (std::size_t i = 1; i + 1 < power.size(); ++i)
      if (power[i] > power[i - 1] && power[i] > power[i + 1] && prominence(i) > most)
        top = i, most = prominence(i);
    return top > 0 ? std::optional(hz[top]) : std::nullopt;
  }
  bool stands_out_at(double f) const {
    if (hz.empty()) return false;
    const auto i = static_cast<std::size_t>(std::max((f - hz.front()) / frequency_step_hz + 0.5, 0.0));
    return i < power.size() && prominence(i) >= stands_out;
  }
};

Spectrum spectrum_of(const Remainder& r) {
  Spectrum s;
  const auto half = static_cast<std::size_t>(0.5 * spectrum_s / r.step_s);
  const double highest = std::min(fastest_hz, 0.2 / r.step_s);
  for (double hz = std::max(slowest_hz, above_breathing / r.period_s); hz <= highest;
       hz += frequency_step_hz) {
    double power = 0, unused = 0;
    for (std::size_t centre = half / 2; centre < r.value.size(); centre += half)
      power += std::norm(demodulated(r, centre, half, hz, unused));
    s.hz.push_back(hz);
    s.power.push_back(power * hz * hz);
  }
  return s;
}

// Returns amplitude and phase of a wave over time, [steps].
std::vector<Phasor> followed(const Remainder& r, double hz, double base_hz) {
  const auto half = static_cast<std::size_t>(0.5 * beats_followed / base_hz / r.step_s);
  std::vector<Phasor> waves;
  for (std::size_t i = 0; i < r.value.size(); ++i) {
    double weight = 0;
    const Phasor sum = demodulated(r, i, half, hz, weight);
    waves.push_back(weight > 0.5 * static_cast<double>(half) ? 2.0 * sum / weight : Phasor{});
  }
  return waves;
}

double mean_square(const std::vector<Phasor>& waves) {
  double sum = 0, count = 0;
  for (const Phasor& wave : waves)
    if (wave != Phasor{}) sum += std::norm(wave), ++count;
  return count > 0 ? sum / count : 0;
}

void add_wave(const Remainder& r, Samples time, const std::vector<Phasor>& waves, double hz, Curve& volume) {
  for (std::size_t i = 0; i < time.size(); ++i) {
    const double at = (time[i] - time.front()) / r.step_s;
    const auto k = std::min(static_cast<std::size_t>(at), waves.size() - 1);
    const double part = at - static_cast<double>(k);
    const Phasor wave = (1 - part) * waves[k] + part * waves[std::min(k + 1, waves.size() - 1)];
    volume[i] += (wave * std::polar(1.0, 2 * std::numbers::pi * hz * time[i])).real();
  }
}

}  // namespace

std::optional<HeartRipple> heart_ripple(Samples time, Samples volume, const Landmarks& marks, double drift) {
  Remainder r(time, volume, volume, marks, drift);
  if (r.empty()) return std::nullopt;
  const Spectrum s = spectrum_of(r);
  const std::optional<double> hz = s.highest_line();
  if (!hz) return std::nullopt;
  HeartRipple ripple;
  ripple.frequency_hz = *hz;
  Curve quiet(volume.begin(), volume.end());
  for (int pass = 0; pass < passes; ++pass) {
    if (pass > 0) r = Remainder(time, volume, quiet, marks, drift);
    ripple.volume.assign(time.size(), 0);
    for (int k = 1; k <= harmonics; ++k) {
      if (k > 1 && !s.stands_out_at(k * *hz)) continue;
      const auto waves = followed(r, k * *hz, *hz);
      if (k == 1) ripple.amplitude = std::sqrt(mean_square(waves));
      add_wave(r, time, waves, k * *hz, ripple.volume);
    }
    const double amplitude = ripple.amplitude / r.tidal_volume;
    if (amplitude < least_amplitude || amplitude > most_amplitude) return std::nullopt;
    for (std::size_t i = 0; i < quiet.size(); ++i) quiet[i] = volume[i] - ripple.volume[i];
  }
  return ripple;
}

}  // namespace trunk
