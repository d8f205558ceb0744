#pragma once

#include <array>
#include <cmath>

#include "math/scalar.hpp"

namespace trunk {

/// The numbers of inner knots of the activation. Each phase is divided evenly by its own knots.
struct ShapeKnots {
  static constexpr std::size_t rise = 5, fast_fall = 1, slow_fall = 3, count = rise + fast_fall + slow_fall;
};

/// Muscle activation A(t) over one breath, as a share of its height at the end of the rise. It consists of a
/// linear rise, an "important decrease" and a "normal decrease" (paper, "Healthy and pathological diaphragm
/// models": 2 s, 0.5 s and 2 s). The fast decrease ends at 0.4 (our choice). A(t) repeats every `period_s` if
/// that is positive, and is never negative.
///
/// `shape` bends the three lines (our choice). Inner knots divide each phase evenly. The height of a knot is
/// that of the line times its `shape`, and A(t) is straight between knots; a shape of 1 leaves the line as it
/// is.
template <Scalar S>
struct BreathActivation {
  S onset_s{0.0};  // negative: the muscle is already active at the start
  S rise_s{2.0};
  S fast_fall_s{0.5};
  S slow_fall_s{2.0};
  S fast_fall_level{0.4};
  S period_s{0.0};
  std::array<S, ShapeKnots::count> shape = filled(1.0);

  /// Returns A at a time of a breath that starts from rest.
  S operator()(double time_s) const noexcept {
    using std::floor;
    const S now(time_s), past = period_s * floor(now / period_s);
    return after_onset(select(S(0.0) < period_s, now - past, now) - onset_s);
  }

  /// Returns A at a time of breathing that repeats: every `period_s` if that is positive, else every
  /// `breath_s`. One activation lasts from its onset to the next onset, which cuts its tail (our choice).
  S repeated(double time_s, double breath_s) const noexcept {
    using std::floor;
    const S cycle_s = select(S(0.0) < period_s, period_s, S(breath_s)), since_first = S(time_s) - onset_s;
    return after_onset(since_first - cycle_s * floor(since_first / cycle_s));
  }

 private:
  /// Returns A at a time after its onset.
  S after_onset(const S& t) const noexcept {
    const S rising = t / rise_s;
    const S falling = S(1.0) - (S(1.0) - fast_fall_level) * (t - rise_s) / fast_fall_s;
    const S end_of_fast = rise_s + fast_fall_s;
    const S settling = fast_fall_level * (S(1.0) - (t - end_of_fast) / slow_fall_s);
    const S line = select(t < rise_s, rising, select(t < end_of_fast, falling, settling));
    const S bent = select(S(0.0) < line, line, S(0.0)) + bend(t);
    return select(S(0.0) < bent, bent, S(0.0));  // round-off
  }

  static constexpr std::array<S, ShapeKnots::count> filled(double value) {
    std::array<S, ShapeKnots::count> all;
    all.fill(S(value));
    return all;
  }

  /// Returns what the knots add to the lines: exactly 0 if the shape is all ones.
  S bend(const S& t) const noexcept {
    const S *knot = shape.data(), zero(0.0), one(1.0);
    return bend(t, zero, rise_s, zero, one, knot, ShapeKnots::rise) +
           bend(t, rise_s, fast_fall_s, one, fast_fall_level, knot + ShapeKnots::rise,
                ShapeKnots::fast_fall) +
           bend(t, rise_s + fast_fall_s, slow_fall_s, fast_fall_level, zero,
                knot + ShapeKnots::rise + ShapeKnots::fast_fall, ShapeKnots::slow_fall);
  }

  /// Returns the same for one phase, from height `first` to `last`: a sum of hat functions, each as wide as
  /// the distance between its two neighbours.
  static S bend(const S& t, const S& start, const S& length, const S& first, const S& last, const S* knot,
                std::size_t count) noexcept {
    const S place = S(static_cast<double>(count + 1)) * (t - start) / length;  // knot k stands at k + 1
    S sum(0.0);
    for (std::size_t k = 0; k < count; ++k) {
      const double part = static_cast<double>(k + 1) / static_cast<double>(count + 1);
      const S away = place - S(static_cast<double>(k + 1));
      const S hat = S(1.0) - select(away < S(0.0), -away, away);
      const S height = first + S(part) * (last - first);
      sum = sum + select(S(0.0) < hat, (knot[k] - S(1.0)) * height * hat, S(0.0));
    }
    return sum;
  }
};

}  // namespace trunk
