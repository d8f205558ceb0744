#include "breaths/aligned_onsets.hpp"

#include <algorithm>
#include <cmath>

#include "math/median.hpp"

namespace trunk {
namespace {

constexpr std::size_t fewest_aligned = 5;
constexpr double before_onset = 0.4, of_inspiration = 0.8;  // fitted, in parts of an inspiration
constexpr double step_of_phase = 0.01, farthest = 0.25, step_of_shift = 0.005;
constexpr double of_rest = 0.25, near_rest = 0.1;  // of the mean inspiration, in which its own onset is found

// The mean volume over phases of inspiration, in parts of a tidal volume: phase 0 is the onset, 1 the peak.
class MeanInspiration {
 public:
  MeanInspiration(const BinnedVolume& level, const std::vector<RoughBreath>& breaths,
                  const std::vector<double>& onsets, const std::vector<bool>& usual) {
    for (double phase = -before_onset; phase <= 1 + step_of_phase; phase += step_of_phase) {
      double sum = 0, count = 0;
      for (std::size_t i = 0; i < breaths.size(); ++i) {
        if (!usual[i]) continue;
        const double t = onsets[i] + phase * (breaths[i].peak_s - onsets[i]);
        sum += interpolated(level.time, level.volume, t) / breaths[i].tidal_volume, ++count;
      }
      mean_.push_back(sum / count);
    }
  }

  double operator()(double phase) const {
    const double at =
        std::clamp((phase + before_onset) / step_of_phase, 0.0, static_cast<double>(mean_.size() - 1));
    const auto k = std::min(static_cast<std::size_t>(at), mean_.size() - 2);
    const double part = at - static_cast<double>(k);
    return (1 - part) * mean_[k] + part * mean_[k + 1];
  }

  // Returns the phase at which the mean itself leaves its rest, with the period of a breath in parts of
  // inspiration.
  double onset(double period) const {
    std::vector<double> phases, volumes;
    for (double phase = -of_rest; phase < 0.9; phase += step_of_phase) {
      if (phase > 0 && (*this)(phase) > near_rest) break;
      phases.push_back(phase), volumes.push_back((*this)(phase));
    }
    return turns_in({{phases, volumes, {}, {}, 1}}, TurnKind::onset, period, NoiseKind::walk).front().end_s;
  }

 private:
  std::vector<double> mean_;
};

// Returns the mean square of what the steps around an onset have beside those of the mean inspiration.
double misfit_at(const BinnedVolume& level, const RoughBreath& breath, const MeanInspiration& mean,
                 double onset_s) {
  const double inspiration = breath.peak_s - breath.onset_s;
  const auto first = std::lower_bound(level.time.begin(), level.time.end(),
                                      breath.onset_s - (before_onset - farthest) * inspiration);
  const double until = breath.onset_s + of_inspiration * inspiration;
  double sum = 0, last = 0, model_last = 0;
  for (auto i = static_cast<std::size_t>(first - level.time.begin()), begin = i;
       i < level.time.size() && level.time[i] < until; ++i) {
    const double model = breath.tidal_volume * mean((level.time[i] - onset_s) / (breath.peak_s - onset_s));
    if (i > begin) sum += std::pow(level.volume[i] - last - (model - model_last), 2);
    last = level.volume[i], model_last = model;
  }
  return sum;
}

double best_onset(const BinnedVolume& level, const RoughBreath& breath, const MeanInspiration& mean) {
  const double inspiration = breath.peak_s - breath.onset_s;
  double best = breath.onset_s, least = HUGE_VAL;
  for (double shift = -farthest; shift <= farthest; shift += step_of_shift) {
    const double onset = breath.onset_s + shift * inspiration;
    if (const double misfit = misfit_at(level, breath, mean, onset); misfit < least)
      least = misfit, best = onset;
  }
  return best;
}

}  // namespace

std::vector<double> aligned_onsets(const BinnedVolume& level, const std::vector<RoughBreath>& breaths) {
  std::vector<double> onsets, sizes;
  for (const RoughBreath& b : breaths) onsets.push_back(b.onset_s), sizes.push_back(b.tidal_volume);
  const double size = median(sizes);
  std::vector<bool> usual;
  for (const double s : sizes) usual.push_back(s > size / 2 && s < size * 2);
  if (static_cast<std::size_t>(std::count(usual.begin(), usual.end(), true)) < fewest_aligned) return onsets;
  const MeanInspiration mean(level, breaths, onsets, usual);
  double moved = 0, count = 0;
  for (std::size_t i = 0; i < breaths.size(); ++i) {
    if (!usual[i]) continue;
    onsets[i] = best_onset(level, breaths[i], mean);
    moved += onsets[i] - breaths[i].onset_s, ++count;
  }
  for (std::size_t i = 0; i < breaths.size(); ++i)
    if (usual[i]) onsets[i] -= moved / count;
  double inspiration_s = 0;
  for (std::size_t i = 0; i < breaths.size(); ++i)
    if (usual[i]) inspiration_s += (breaths[i].peak_s - onsets[i]) / count;
  const double late = MeanInspiration(level, breaths, onsets, usual).onset(level.period / inspiration_s);
  for (std::size_t i = 0; i < breaths.size(); ++i)
    if (usual[i]) onsets[i] += late * (breaths[i].peak_s - onsets[i]);
  return onsets;
}

}  // namespace trunk
