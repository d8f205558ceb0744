#pragma once

#include <cmath>

#include "math/scalar.hpp"

namespace trunk {

/// Muscle activation A(t) in 0..1 over one breath: a linear rise, an "important decrease", a "normal
/// decrease" (paper, "Healthy and pathological diaphragm models": 2 s, 0.5 s, 2 s). How far the fast decrease
/// falls is our choice: 0.4. Repeats every `period_s` when that is positive.
template <Scalar S>
struct BreathActivation {
  S onset_s{0.0};
  S rise_s{2.0};
  S fast_fall_s{0.5};
  S slow_fall_s{2.0};
  S fast_fall_level{0.4};
  S period_s{0.0};

  S operator()(double time_s) const noexcept {
    using std::floor;
    const S now(time_s), past = period_s * floor(now / period_s);
    const S t = select(S(0.0) < period_s, now - past, now) - onset_s;
    const S rising = t / rise_s;
    const S falling = S(1.0) - (S(1.0) - fast_fall_level) * (t - rise_s) / fast_fall_s;
    const S end_of_fast = rise_s + fast_fall_s;
    const S settling = fast_fall_level * (S(1.0) - (t - end_of_fast) / slow_fall_s);
    const S active = select(t < rise_s, rising, select(t < end_of_fast, falling, settling));
    return select(S(0.0) < active, active, S(0.0));
  }
};

}  // namespace trunk
