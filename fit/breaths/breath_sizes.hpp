#pragma once

#include <cstddef>
#include <vector>

#include "breaths/breath.hpp"

namespace trunk {

/// A part of a recording in which the breaths have one size.
struct SizedPart {
  std::size_t first = 0, last = 0;  ///< positions of its breaths in the list
  double tidal_volume_m3 = 0;       ///< median
  bool main = true;                 ///< it has the size of most breaths of the recording
};

/// Returns the parts of a recording in order, if its breaths have more than one size, as at rest and in
/// exercise; else nothing. Sizes are running medians over seven breaths, so that a sigh is none. Those within
/// a factor of 1.5 are one size, and a part has six breaths or more (our choice).
std::vector<SizedPart> breath_sizes(const std::vector<Breath>& breaths);

}  // namespace trunk
