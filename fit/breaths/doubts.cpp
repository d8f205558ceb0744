#include "breaths/doubts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "breaths/robust.hpp"
#include "math/units.hpp"
#include "text/message_text.hpp"

namespace trunk {
namespace {

constexpr double small_m3 = 150e-6, slow_s = 2.5;
constexpr double beyond_lungs_m3 = 12e-3, drifting = 0.5;
constexpr double outer_part = 0.05, breaths_of_piece = 1.5, change_of_size = 6;
constexpr std::size_t shortest = 2;

std::string little_air(double tidal_volume_m3, double period_s) {
  if (!(tidal_volume_m3 > 0 && tidal_volume_m3 < small_m3 && period_s > slow_s)) return "";
  return fmt::format(
      "breaths of {:.0f} ml that last {:.1f} s move {:.1f} L/min: an adult needs more, and an infant "
      "breathes faster; is the unit right?",
      ml_per_m3 * tidal_volume_m3, period_s, litres_per_m3 * tidal_volume_m3 * s_per_min / period_s);
}

std::string beyond_lungs(const Trace& trace) {
  if (trace.kind != SignalKind::volume) return "";
  const auto [low, high] = std::minmax_element(trace.value.begin(), trace.value.end());
  const double least = *low > 0 ? *low : -*high;  // positive if the sign never changes
  if (least < beyond_lungs_m3 || *high - *low > drifting * least) return "";
  return fmt::format("the volume lies between {} and {} L, more than lungs hold: is the column a volume?",
                     number_text(litres_per_m3 * *low, 3), number_text(litres_per_m3 * *high, 3));
}

// Returns the range of a piece of a volume about its line of regression.
double size_of(const std::vector<double>& time, const std::vector<double>& volume, std::size_t first,
               std::size_t end) {
  const auto n = static_cast<double>(end - first);
  double mean_time = 0, mean = 0, covariance = 0, variance = 0;
  for (std::size_t i = first; i < end; ++i) mean_time += time[i] / n, mean += volume[i] / n;
  for (std::size_t i = first; i < end; ++i) {
    const double t = time[i] - mean_time;
    covariance += t * (volume[i] - mean), variance += t * t;
  }
  std::vector<double> level;
  for (std::size_t i = first; i < end; ++i)
    level.push_back(volume[i] - covariance / variance * (time[i] - mean_time));
  return quantile(level, 1 - outer_part) - quantile(level, outer_part);
}

}  // namespace

std::string change_of_unit(const std::vector<double>& time, const std::vector<double>& volume,
                           double period_s) {
  std::vector<double> size, begin_s;
  for (std::size_t first = 0, i = 0; i < time.size(); ++i) {
    if (time[i] - time[first] < breaths_of_piece * period_s) continue;
    size.push_back(size_of(time, volume, first, i));
    begin_s.push_back(time[first]);
    first = i;
  }
  for (std::size_t k = shortest; k + 1 + shortest <= size.size(); ++k) {
    const auto change = size.begin() + static_cast<std::ptrdiff_t>(k);  // both units may be in this piece
    const auto [low, high] = std::minmax_element(size.begin(), change);
    const auto [low_after, high_after] = std::minmax_element(change + 1, size.end());
    const double smaller = *low / *high_after, larger = *low_after / *high;
    if (smaller <= change_of_size && larger <= change_of_size) continue;
    return fmt::format(
        "from about {} s on, what moves is {} times as {} as before: does the unit change there, or is it a "
        "pause? give each part as a file of its own",
        number_text(begin_s[k], 3), number_text(std::min(std::max(smaller, larger), 1e3), 2),
        smaller > larger ? "small" : "large");
  }
  return "";
}

std::vector<std::string> doubts(const Trace& trace, const std::vector<double>& time_s,
                                const std::vector<double>& volume_m3, bool calibrated, double tidal_volume_m3,
                                double period_s) {
  std::vector<std::string> found{calibrated ? little_air(tidal_volume_m3, period_s) : "", beyond_lungs(trace),
                                 change_of_unit(time_s, volume_m3, period_s)};
  std::erase(found, "");
  return found;
}

}  // namespace trunk
