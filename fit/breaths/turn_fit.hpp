#pragma once

#include <array>
#include <span>

namespace trunk {

/// How a volume runs into a turn and out of it: as powers of the time to it and from it. A flow that stops or
/// starts at once gives 1, one that fades or grows evenly 2.
struct TurnShape {
  double before = 2, after = 2;
};

/// The shapes tried; which one holds is a property of the recording (our choice of powers).
inline constexpr std::array turn_powers{1.0, 2.0};

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
///     level + b (begin - t)^before   for t < begin
///     level                          from begin to end
///     level + a (t - end)^after      for t > end,          a, b >= 0
///
/// in level, a, b, begin and end. Unlike an extreme or a threshold, it uses what lies on both sides, so that
/// noise neither lowers the level nor moves the ends to one side (our choice). A side that is not shown
/// stays level up to the first or last sample. More than 400 samples are averaged in groups.
Turn fit_turn(std::span<const double> time_s, std::span<const double> volume, TurnShape shape,
              TurnSides sides);

}  // namespace trunk
