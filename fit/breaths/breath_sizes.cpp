#include "breaths/breath_sizes.hpp"

#include <algorithm>

#include "breaths/median_of.hpp"
#include "math/median.hpp"

namespace trunk {
namespace {

constexpr std::size_t half_width = 3, fewest = 6;
constexpr double alike = 1.5;

using Sizes = std::vector<double>;

Sizes running_medians(const std::vector<Breath>& breaths) {
  Sizes sizes;
  for (std::size_t i = 0; i < breaths.size(); ++i) {
    const auto begin = breaths.begin() + static_cast<std::ptrdiff_t>(i - std::min(i, half_width));
    const auto end =
        breaths.begin() + static_cast<std::ptrdiff_t>(std::min(i + half_width + 1, breaths.size()));
    sizes.push_back(median_of({begin, end}, tidal_volume_of));
  }
  return sizes;
}

bool are_alike(double one, double other) {
  return one < alike * other && other < alike * one;
}

// Returns the size with which most of those that are left are alike; the first of several.
double most_common(const Sizes& left) {
  Sizes sorted = left;
  std::sort(sorted.begin(), sorted.end());
  double best = 0;
  std::ptrdiff_t most = 0;
  for (const double size : left) {
    const auto low = std::upper_bound(sorted.begin(), sorted.end(), size / alike);
    const auto high = std::lower_bound(low, sorted.end(), size * alike);
    if (high - low > most) most = high - low, best = size;
  }
  return best;
}

// Returns the kind of each size: 0 for the most common ones.
std::vector<int> kinds_of(const Sizes& sizes) {
  std::vector<int> kinds(sizes.size(), -1);
  Sizes left = sizes;
  for (int kind = 0; !left.empty(); ++kind) {
    const double common = most_common(left);
    left.clear();
    for (std::size_t i = 0; i < sizes.size(); ++i) {
      if (kinds[i] >= 0) continue;
      if (are_alike(sizes[i], common))
        kinds[i] = kind;
      else
        left.push_back(sizes[i]);
    }
  }
  return kinds;
}

}  // namespace

std::vector<SizedPart> breath_sizes(const std::vector<Breath>& breaths) {
  const std::vector<int> kinds = kinds_of(running_medians(breaths));
  std::vector<SizedPart> parts;
  for (std::size_t first = 0, next = 0; first < kinds.size(); first = next) {
    while (next < kinds.size() && kinds[next] == kinds[first]) ++next;
    if (next - first < fewest) continue;
    const auto at = [&](std::size_t i) { return breaths.begin() + static_cast<std::ptrdiff_t>(i); };
    parts.push_back({first, next - 1, median_of({at(first), at(next)}, tidal_volume_of), kinds[first] == 0});
  }
  const auto other = [](const SizedPart& part) { return !part.main; };
  if (std::none_of(parts.begin(), parts.end(), other) || std::all_of(parts.begin(), parts.end(), other))
    return {};
  return parts;
}

}  // namespace trunk
