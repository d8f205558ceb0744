#include "breaths/shallow_breaths.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "breaths/above_noise.hpp"
#include "breaths/robust.hpp"
#include "math/median.hpp"

namespace trunk {
namespace {

constexpr double least_rise = 0.08, clear_rise = 0.3;                                // of the usual one
constexpr double least_noise = 8;                                                    // deviations
constexpr double least_length = 0.12, most_length = 4, slow = 2, whole_cycle = 0.6;  // of the usual cycle
constexpr double at_level = 0.1;   // of a height: where a breath leaves its rest
constexpr std::size_t nearby = 5;  // rises on either side
constexpr std::size_t fewest_rises = 3;

using Volume = std::span<const double>;
using TurnList = std::vector<TurningPoint>;

// What is usual in a record and near a sample of it.
class Usual {
 public:
  Usual(Volume volume, const TurnList& turns) : heights_(rises(volume, turns)) {
    std::vector<double> cycles;
    for (const TurningPoint& turn : turns)
      if (turn.peak && (&turn != &turns.front())) {
        if (!peaks_.empty()) cycles.push_back(static_cast<double>(turn.index - peaks_.back()));
        peaks_.push_back(turn.index);
      }
    height_ = median(heights_);
    cycle_ = median(std::move(cycles));
  }

  double height() const { return height_; }
  double cycle() const { return cycle_; }  ///< samples from peak to peak

  double height_near(std::size_t sample) const {
    const auto at =
        static_cast<std::size_t>(std::lower_bound(peaks_.begin(), peaks_.end(), sample) - peaks_.begin());
    const std::size_t first = at > nearby ? at - nearby : 0, end = std::min(at + nearby, heights_.size());
    return median({heights_.begin() + static_cast<std::ptrdiff_t>(first),
                   heights_.begin() + static_cast<std::ptrdiff_t>(end)});
  }

 private:
  std::vector<double> heights_;
  std::vector<std::size_t> peaks_;
  double height_ = 0, cycle_ = 0;
};

// Drops from fine turns the rises that are no breaths, from the smallest on.
class Shallow {
 public:
  Shallow(Volume volume, const TurnList& usual, TurnList fine)
      : volume_(volume), usual_(volume, usual), turns_(std::move(fine)) {}

  TurnList settled() {
    while (drop_smallest()) {
    }
    return std::move(turns_);
  }

 private:
  double at(std::size_t k) const { return volume_[turns_[k].index]; }
  double samples(std::size_t from, std::size_t until) const {
    return static_cast<double>(turns_[until].index - turns_[from].index);
  }

  // Drops the least pair of neighbours that is no breath. Returns false if there is none.
  bool drop_smallest() {
    std::size_t least = turns_.size();
    double smallest = HUGE_VAL;
    for (std::size_t k = 0; k + 1 < turns_.size(); ++k) {
      const double height = std::abs(at(k + 1) - at(k));
      if (height >= smallest) continue;
      const bool clear = height >= clear_rise * usual_.height_near(turns_[k].index);
      if (clear ? is_slow_noise(k) : !is_breath(k)) least = k, smallest = height;
    }
    if (least == turns_.size()) return false;
    const auto begin = turns_.begin() + static_cast<std::ptrdiff_t>(least);
    if (least == 0)
      turns_.erase(begin);  // what the record cuts
    else if (least + 2 == turns_.size())
      turns_.erase(begin + 1);
    else
      turns_.erase(begin, begin + 2);
    return true;
  }

  // Says whether the peak of the pair k, k+1, which is lower than the one beyond its trough, is a breath.
  bool is_breath(std::size_t k) {
    const std::size_t peak = turns_[k].peak ? k : k + 1, trough = turns_[k].peak ? k + 1 : k;
    if (peak == 0 || peak + 1 >= turns_.size()) return false;
    const std::size_t from = turns_[peak - 1].index, until = turns_[peak + 1].index;
    const auto key = std::pair{from, until};
    const auto [core_from, core_until] = core(peak);
    const auto length = static_cast<double>(core_until - core_from);
    if (length < least_length * usual_.cycle() || length > most_length * usual_.cycle()) return false;
    if (!returns(peak) && !are_cycles(peak, trough)) return false;
    const auto known = smooth_.find(key);
    if (known != smooth_.end()) return known->second;
    return smooth_[key] = clearly_above_noise(volume_, core_from, turns_[peak].index, core_until);
  }

  // Says whether a pair of clear height is an excursion of noise that lasts longer than breaths.
  bool is_slow_noise(std::size_t k) const {
    const std::size_t peak = turns_[k].peak ? k : k + 1;
    if (peak == 0 || peak + 1 >= turns_.size()) return false;
    const auto [from, until] = core(peak);
    return static_cast<double>(until - from) > slow * usual_.cycle() &&
           !above_noise(volume_, from, turns_[peak].index, until);
  }

  bool returns(std::size_t peak) const {
    return std::abs(at(peak + 1) - at(peak - 1)) <= at(peak) - std::max(at(peak - 1), at(peak + 1));
  }

  // Says whether the trough parts two cycles of usual length.
  bool are_cycles(std::size_t peak, std::size_t trough) const {
    const bool before = trough < peak;  // the other cycle
    if (before ? trough < 2 : trough + 2 >= turns_.size()) return false;
    const double least = whole_cycle * usual_.cycle();
    return samples(peak - 1, peak + 1) >= least &&
           (before ? samples(trough - 2, trough) : samples(trough, trough + 2)) >= least;
  }

  // Returns the samples between which the volume is above rest: a pause may be long.
  std::pair<std::size_t, std::size_t> core(std::size_t peak) const {
    const std::size_t top = turns_[peak].index;
    std::size_t from = top, until = top;
    const auto low = [&](std::size_t trough) { return at(trough) + at_level * (at(peak) - at(trough)); };
    while (from > turns_[peak - 1].index && volume_[from] > low(peak - 1)) --from;
    while (until < turns_[peak + 1].index && volume_[until] > low(peak + 1)) ++until;
    return {from, until};
  }

  Volume volume_;
  Usual usual_;
  TurnList turns_;
  std::map<std::pair<std::size_t, std::size_t>, bool> smooth_;  // by first and last sample
};

}  // namespace

TurnList with_shallow_breaths(Volume volume, TurnList turns) {
  const auto heights = rises(volume, turns);
  if (heights.size() < fewest_rises) return turns;
  const double usual = median(heights);
  const double threshold = std::max(least_rise * usual, least_noise * noise_deviation(volume));
  if (threshold >= clear_rise * usual) return turns;
  return Shallow(volume, turns, turning_points(volume, threshold)).settled();
}

}  // namespace trunk
