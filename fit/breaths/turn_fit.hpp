#pragma once

#include <span>

namespace trunk {

/// The time constants with which the flow fades before a turn and grows after it. A flow that stops or starts
/// at once has 0; a flow that changes linearly has infinity. A passive chest under a growing force is
/// between.
struct TurnShape {
  double before_s, after_s;
};

/// Returns the volume at a time s >= 0 from a turn, up to a factor: the integral of 1 - exp(-s/lag), or its
/// limits s and s^2.
double volume_from_turn(double s, double lag_s);

/// A rest between two breaths, or, in an inverted volume, the top of a breath.
struct Turn {
  double begin_s = 0, end_s = 0;  ///< of the level part; equal if there is none
  double level = 0;               ///< volume there
  double misfit = 0;              ///< mean square residual
};

/// The noise of a volume: independent from sample to sample, or a walk, the sum of what a flow has. Of a
/// walk, steps are fitted and not volumes.
enum class NoiseKind { white, walk };

/// Which sides of a turn the samples show: the fall before it, the rise after it, or both.
struct TurnSides {
  bool before = true, after = true;
};

/// Returns the least-squares fit, over all samples around a turn (at least one; time increases), of
///
///     level + b v(begin - t; before)   for t < begin
///     level                            from begin to end
///     level + a v(t - end; after)      for t > end,   a, b >= 0, v = volume_from_turn
///
/// in level, a, b, begin and end. An extreme or a threshold uses only one side; this fit uses both, so noise
/// neither lowers the level nor moves the ends to one side (our choice). A side that is not shown stays level
/// up to the first or last sample. More than 400 samples are averaged in groups.
Turn fit_turn(std::span<const double> time_s, std::span<const double> volume, TurnShape shape,
              TurnSides sides, NoiseKind noise = NoiseKind::white);

}  // namespace trunk
