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

}  // namespace trunk
