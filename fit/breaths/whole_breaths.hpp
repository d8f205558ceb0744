#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace trunk {

/// Whole breaths as samples: breath i falls to rest at trough[i], rises to peak[i] and falls to trough[i+1].
struct WholeBreaths {
  std::vector<std::size_t> trough;  ///< [n+1], or empty
  std::vector<std::size_t> peak;    ///< [n]
  double height = 0;                ///< median rise, m3
  double drift = 0;                 ///< median slope between troughs, m3/s; 0 if fewer than two are inside
  std::size_t inspirations = 0;     ///< rises seen, whole or cut
};

/// Returns the whole breaths of a continuous volume (m3) at times (s), at least 10 of each. A breath at the
/// start or end of the record counts as whole only if the volume there is within 10 % of a height from rest
/// (our choice). Finding no breath is not an error.
WholeBreaths whole_breaths(std::span<const double> time_s, std::span<const double> volume_m3);

}  // namespace trunk
