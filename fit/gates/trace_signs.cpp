#include "gates/trace_signs.hpp"

#include <gsl/gsl_fit.h>

#include <algorithm>
#include <cmath>

#include "breaths/median_of.hpp"

namespace trunk {
namespace {

constexpr std::size_t breaths_in_block = 60, fewest_rests = 4;

// Returns the standard deviation of some knots about their straight line.
double deviation_from_line(const KnotLine& rest, std::size_t first, std::size_t count) {
  double level = 0, slope = 0, unused[3], squares = 0;
  gsl_fit_linear(&rest.time[first], 1, &rest.value[first], 1, count, &level, &slope, &unused[0], &unused[1],
                 &unused[2], &squares);
  return std::sqrt(squares / static_cast<double>(count - 2));
}

double wander_m3(const KnotLine& rest) {
  std::vector<double> deviations;
  const std::size_t blocks = (rest.time.size() + breaths_in_block - 1) / breaths_in_block;
  for (std::size_t k = 0; k < blocks; ++k) {
    const std::size_t first = k * rest.time.size() / blocks, end = (k + 1) * rest.time.size() / blocks;
    if (end - first >= fewest_rests) deviations.push_back(deviation_from_line(rest, first, end - first));
  }
  return median(std::move(deviations));
}

// Says whether in- less expired volume is a share of each breath's volume, or one flow in all breaths: what
// one of the two leaves of it is less than half of what the other leaves.
void find_cause(const std::vector<Breath>& breaths, TraceSigns& signs) {
  constexpr std::size_t fewest = 5;
  if (breaths.size() < fewest) return;
  const auto left = [&](auto of) {
    double products = 0, squares = 0, rest = 0;
    for (const Breath& b : breaths)
      products += of(b) * (b.inspired_m3 - b.expired_m3), squares += of(b) * of(b);
    for (const Breath& b : breaths) {
      const double apart = b.inspired_m3 - b.expired_m3 - products / squares * of(b);
      rest += apart * apart;
    }
    return rest;
  };
  const double by_size = left([](const Breath&b) { return b.inspired_m3 + b.expired_m3; }),
               by_duration = left([](const Breath&b) { return b.duration_s(); });
  signs.mismatch_by_size = by_size < 0.5 * by_duration;
  signs.mismatch_by_duration = by_duration < 0.5 * by_size;
}

}  // namespace

TraceSigns trace_signs(const Segmentation& s) {
  const std::vector<Breath> breaths = breaths_to_judge(s);
  TraceSigns signs;
  signs.orientation = orientation(s, breaths);
  signs.gain_mismatch = median_of(breaths, [](const Breath& b) {
    return 2 * (b.inspired_m3 - b.expired_m3) / (b.inspired_m3 + b.expired_m3);
  });
  find_cause(breaths, signs);
  signs.tidal_volume_m3 = median_of(breaths, [](const Breath& b) { return b.tidal_volume_m3; });
  signs.inspiration_s = median_of(breaths, [](const Breath& b) { return b.inspiration_s(); });
  signs.inspired_part =
      median_of(breaths, [](const Breath& b) { return b.inspiration_s() / b.duration_s(); });
  signs.wander = wander_m3(s.rest) / signs.tidal_volume_m3;
  signs.step_s = (s.time_s.back() - s.time_s.front()) / static_cast<double>(s.time_s.size() - 1);
  signs.breaths = static_cast<std::size_t>(
      std::count_if(s.breaths.begin(), s.breaths.end(), [](const Breath& b) { return b.kept; }));
  return signs;
}

}  // namespace trunk
