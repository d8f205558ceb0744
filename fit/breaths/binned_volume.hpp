#pragma once

#include <span>
#include <vector>

#include "breaths/knot_line.hpp"
#include "breaths/turn_fit.hpp"
#include "breaths/whole_breaths.hpp"

namespace trunk {

/// The largest part of a height around a turn that is fitted (our choice).
inline constexpr double around_at_most = 0.35;

/// A record in bins of at least a two-hundredth of a breath (at least one sample), and the bins of its
/// turning points.
struct BinnedVolume {
  std::vector<double> time, volume;       ///< [bins] means over a bin
  std::vector<double> smooth;             ///< [bins] volume, averaged as much as its noise requires
  std::vector<std::size_t> trough, peak;  ///< [n+1], [n]
  double period = 0;                      ///< of a breath, median, s
  double noise = 0;                       ///< deviation of `smooth`
  double around = 0;                      ///< part of a height around turns that is fitted
  double walk = 0;                    ///< how far its noise strays in a tenth of a breath, if it is a walk
  NoiseKind kind = NoiseKind::white;  ///< of `volume`
  double closely = 0;                 ///< the least such part that stands out of the noise

  /// Sets everything but `smooth`, `noise` and `around`.
  BinnedVolume(std::span<const double> time_s, std::span<const double> samples, const WholeBreaths& breaths);

  /// Returns the volume above a base line, inverted if sign is -1, and sets what depends on its noise.
  BinnedVolume above(const KnotLine& rest, double slope_outside, double height, double sign = 1) const;
};

/// Returns the last bin that begins at a time or before.
std::size_t bin_at(std::span<const double> begins, double time);

}  // namespace trunk
