#pragma once

#include "math/scalar.hpp"

namespace trunk {

/// Follows a number over a breath: its first value, its highest and its lowest.
template <Scalar S>
struct Extremes {
  S first{0.0}, lowest{0.0}, highest{0.0};
  bool begun = false;

  void operator()(const S& value) noexcept {
    if (!begun) first = lowest = highest = value;
    begun = true;
    lowest = select(value < lowest, value, lowest);
    highest = select(highest < value, value, highest);
  }

  /// Returns the change from the first value that is the largest in size, with its sign.
  S swing() const noexcept {
    const S up = highest - first, down = lowest - first;
    return select(up < -down, down, up);
  }
};

}  // namespace trunk
