#pragma once

#include <span>

namespace trunk {

/// How a volume runs into a turn and out of it: the time constants with which its flow fades and grows. Flow
/// that stops or starts at once has 0, one that changes evenly has infinity; in between is that of a passive
/// chest which answers a force that grows.
struct TurnShape {
  double before_s, after_s;
};

/// The volume a time s >= 0 from a turn, up to a factor: the integral of 1 - exp(-s/lag), or its limits s and
/// s^2.
double volume_from_turn(double s, double lag_s);

/// A rest between two breaths, or (of the volume turned upside down) the top of one.
struct Turn {
  double begin_s = 0, end_s = 0;  ///< of the level part; equal when there is none
  double level = 0;               ///< volume there
  double misfit = 0;              ///< mean square residual
};

/// What the samples around a turn show: a way down into it, a way up out of it, or both.
struct TurnSides {
  bool before = true, after = true;
};

/// Least squares over all samples around a turn (at least one; time increases) of
///
///     level + b v(begin - t; before)   for t < begin
///     level                            from begin to end
///     level + a v(t - end; after)      for t > end,   a, b >= 0, v = volume_from_turn
///
/// in level, a, b, begin and end. Unlike an extreme or a threshold, it uses what lies on both sides, so that
/// noise neither lowers the level nor moves the ends to one side (our choice). A side that is not shown
/// stays level up to the first or last sample. More than 400 samples are averaged in groups.
Turn fit_turn(std::span<const double> time_s, std::span<const double> volume, TurnShape shape,
              TurnSides sides);

}  // namespace trunk
