#pragma once

#include <span>
#include <vector>

#include "breaths/knot_line.hpp"
#include "breaths/turn_fit.hpp"
#include "breaths/whole_breaths.hpp"

namespace trunk {

/// A record in bins of at least a two-hundredth of a breath (at least one sample), and the bins of its
/// turning points.
struct BinnedVolume {
  std::vector<double> time, volume;       ///< [bins] means over a bin
  std::vector<double> smooth;             ///< [bins] volume, averaged as much as its noise requires
  std::vector<std::size_t> trough, peak;  ///< [n+1], [n]
  double period = 0;                      ///< of a breath, median, s
  double noise = 0;                       ///< deviation of `smooth`
  double around = 0;                      ///< part of a height around turns that is fitted

  /// Sets everything but `smooth`, `noise` and `around`.
  BinnedVolume(std::span<const double> time_s, std::span<const double> samples, const WholeBreaths& breaths);

  /// Returns the volume above a base line, inverted if sign is -1, and sets what depends on its noise.
  BinnedVolume above(const KnotLine& rest, double slope_outside, double height, double sign = 1) const;
};

/// How much of a height around a turn is fitted: close is a tenth and more if there is noise, wide is 0.35.
enum class Nearness { close, wide };

/// The part of a record that is fitted around one turn; the volume rises away from it. Views of a
/// BinnedVolume.
struct TurnWindow {
  std::span<const double> time, volume, smooth;
  TurnSides sides;
  double height = 0;  ///< of the breath
};

/// Returns a window around each rest [n+1]. A long pause is shortened to its end, about four times as long as
/// the part of the inspiration in the window.
std::vector<TurnWindow> around_onsets(const BinnedVolume& level, Nearness nearness);

/// Returns a window around each rest [n+1], with its whole pause.
std::vector<TurnWindow> around_pauses(const BinnedVolume& level);

/// Returns a window around each top [n] of an inverted volume.
std::vector<TurnWindow> around_tops(const BinnedVolume& depth);

enum class TurnKind { onset, other };

/// Returns the fitted turns, all with one shape: that with the least mean log misfit over up to 40 windows.
/// Flow changes at once or linearly; at an onset it may also grow with a time constant of 0.01 to 0.16
/// breaths (our choice).
std::vector<Turn> turns_in(const std::vector<TurnWindow>& windows, TurnKind kind, double period);

}  // namespace trunk
