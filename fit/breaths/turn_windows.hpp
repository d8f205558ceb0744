#pragma once

#include <span>
#include <vector>

#include "breaths/knot_line.hpp"
#include "breaths/turn_fit.hpp"
#include "breaths/whole_breaths.hpp"

namespace trunk {

/// A record in bins of a two-hundredth of a breath or more (one sample at least), and the bins of its turning
/// points.
struct BinnedVolume {
  std::vector<double> time, volume;       ///< [bins] means over a bin
  std::vector<double> smooth;             ///< [bins] volume, averaged as far as noise asks for it
  std::vector<std::size_t> trough, peak;  ///< [n+1], [n]
  double period = 0;                      ///< of a breath, median, s
  double noise = 0;                       ///< deviation of `smooth`
  double around = 0;                      ///< part of a height about turns that is fitted

  /// Everything but `smooth`, `noise` and `around`.
  BinnedVolume(std::span<const double> time_s, std::span<const double> samples, const WholeBreaths& breaths);

  /// The volume above a base line (slope outside as given), upside down where sign is -1, and what follows
  /// from its noise.
  BinnedVolume above(const KnotLine& rest, double slope_outside, double height, double sign = 1) const;
};

/// How near a turn is looked at: a tenth of a height and what noise asks for beyond, or always 0.35.
enum class Nearness { close, wide };

/// What is fitted around one turn; the volume rises away from it. Views of a BinnedVolume.
struct TurnWindow {
  std::span<const double> time, volume, smooth;
  TurnSides sides;
  double height = 0;  ///< of the breath
};

/// Around each rest [n+1]; of a long pause the end, about four times as long as what is seen of the
/// inspiration.
std::vector<TurnWindow> around_onsets(const BinnedVolume& level, Nearness nearness);

/// Around each rest [n+1], with all of its pause.
std::vector<TurnWindow> around_pauses(const BinnedVolume& level);

/// Around each top [n] of a volume that is upside down.
std::vector<TurnWindow> around_tops(const BinnedVolume& depth);

enum class TurnKind { onset, other };

/// All in one shape: that with the least mean log misfit (of up to 40 of them, which are enough). Flow
/// changes at once or evenly; that of an onset may also grow with a time constant of 0.01 to 0.16 breaths
/// (our choice).
std::vector<Turn> turns_in(const std::vector<TurnWindow>& windows, TurnKind kind, double period);

}  // namespace trunk
