#pragma once

#include <utility>
#include <vector>

#include "breaths/breath.hpp"
#include "math/median.hpp"

namespace trunk {

/// Returns the median of measure(breath) over breaths; 0 if there are none.
template <class Measure>
double median_of(const std::vector<Breath>& breaths, Measure measure) {
  std::vector<double> values;
  for (const Breath& breath : breaths) values.push_back(measure(breath));
  return median(std::move(values));
}

inline double tidal_volume_of(const Breath& breath) {
  return breath.tidal_volume_m3;
}

inline double duration_of(const Breath& breath) {
  return breath.duration_s();
}

}  // namespace trunk
