#pragma once

#include <span>
#include <vector>

#include "breaths/binned_volume.hpp"
#include "breaths/turn_fit.hpp"

namespace trunk {

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

/// Returns a window around each top [n] in single samples of an inverted volume. It is as low as noise
/// allows, since a shape is exact near its turn only: from half a hundredth of the height on (our choice).
/// `known`: the turns in around_tops.
std::vector<TurnWindow> closely_around_tops(std::span<const double> time_s, std::span<const double> depth,
                                            const BinnedVolume& bins, const std::vector<Turn>& known,
                                            const std::vector<TurnWindow>& windows);

enum class TurnKind { onset, other };

/// Returns the fitted turns, all with one shape: that with the least mean log misfit over up to 40 windows.
/// Flow changes at once or linearly; at an onset it may also grow with a time constant of 0.01 to 0.16
/// breaths (our choice).
std::vector<Turn> turns_in(const std::vector<TurnWindow>& windows, TurnKind kind, double period,
                           NoiseKind noise);

}  // namespace trunk
