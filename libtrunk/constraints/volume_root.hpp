#pragma once

#include <optional>

#include "math/scalar.hpp"

namespace trunk {

/// Enclosed volume along a direction: V(x + lambda d) = c0 + c1 lambda + c2 lambda^2 + c3 lambda^3, m3.
template <Scalar S>
struct VolumeCubic {
  S c0, c1, c2, c3;

  S operator()(const S& lambda) const noexcept { return c0 + lambda * (c1 + lambda * (c2 + lambda * c3)); }
  S slope(const S& lambda) const noexcept { return c1 + lambda * (S(2.0) * c2 + lambda * S(3.0) * c3); }
};

/// The real root of cubic(lambda) = target nearest to 0, by GSL's closed form; none where there is no real
/// root or a coefficient is not finite. The slow way out, and the oracle of the tests.
std::optional<double> nearest_real_root(const VolumeCubic<double>& cubic, double target) noexcept;

/// The root nearest 0 by Newton's method from 0; a few steps reach round-off, since a time step changes the
/// volume little. Where it has not arrived the caller sees cubic(root) != target.
template <Scalar S>
S newton_root(const VolumeCubic<S>& cubic, const S& target) noexcept {
  S lambda = (target - cubic.c0) / cubic.c1;
  for (int i = 0; i < 3; ++i) lambda = lambda - (cubic(lambda) - target) / cubic.slope(lambda);
  return lambda;
}

/// The root used by the kernel: Newton's, and the closed form in the lanes where Newton fails; NaN where
/// there is none.
template <Scalar S>
S solve_volume(const VolumeCubic<S>& cubic, const S& target) noexcept {
  S lambda = newton_root(cubic, target);
  const auto size = [](const S& a) { return select(a < S(0.0), -a, a); };
  const S error = size(cubic(lambda) - target);
  const Mask<S> missed = Mask<S>((S(1e-13) * size(target) < error) | !finite(error));
  if (!any(missed)) return lambda;
  for (int i = 0; i < lanes_of<S>; ++i) {
    if (!in_lane(missed, i)) continue;
    const VolumeCubic<double> alone{in_lane(cubic.c0, i), in_lane(cubic.c1, i), in_lane(cubic.c2, i),
                                    in_lane(cubic.c3, i)};
    set_lane(lambda, i, nearest_real_root(alone, in_lane(target, i)).value_or(std::nan("")));
  }
  return lambda;
}

}  // namespace trunk
