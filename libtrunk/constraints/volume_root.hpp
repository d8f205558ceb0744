#pragma once

#include <optional>

#include "math/dual.hpp"

namespace trunk {

/// The enclosed volume along a direction: V(x + lambda d) = c0 + c1 lambda + c2 lambda^2 + c3 lambda^3, m3.
template <Scalar S>
struct VolumeCubic {
  S c0, c1, c2, c3;

  S operator()(const S& lambda) const noexcept { return c0 + lambda * (c1 + lambda * (c2 + lambda * c3)); }
  S slope(const S& lambda) const noexcept { return c1 + lambda * (S(2.0) * c2 + lambda * S(3.0) * c3); }
};

/// Returns the real root of cubic(lambda) = target that is nearest to 0, by GSL's closed form; nothing if
/// there is no real root or if a coefficient is not finite. It is slow: the kernel needs it only if Newton's
/// method fails, and the tests compare with it.
std::optional<double> nearest_real_root(const VolumeCubic<double>& cubic, double target) noexcept;

/// Returns the root nearest to 0 by Newton's method from 0. A few steps reach round-off, since a time step
/// changes the volume little. The caller has to check that cubic(root) is the target.
template <Scalar S>
S newton_root(const VolumeCubic<S>& cubic, const S& target) noexcept {
  S lambda = (target - cubic.c0) / cubic.c1;
  for (int i = 0; i < 3; ++i) lambda = lambda - (cubic(lambda) - target) / cubic.slope(lambda);
  return lambda;
}

/// Returns the root for the kernel: that of Newton's method, or of the closed form in the lanes where
/// Newton's method fails; NaN if there is none.
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

/// Returns the root of the values of a Dual; its tangents are 0.
template <int N>
Dual<N> solve_volume(const VolumeCubic<Dual<N>>& cubic, const Dual<N>& target) noexcept {
  const VolumeCubic<double> values{cubic.c0.value, cubic.c1.value, cubic.c2.value, cubic.c3.value};
  return Dual<N>(solve_volume(values, target.value));
}

/// Returns the root as a differentiable function of cubic and target. The value does not change. The tangents
/// of a Dual are those of one Newton step, which makes them exact.
template <Scalar S>
S differentiable_root(const S& root, const VolumeCubic<S>&, const S&) noexcept {
  return root;
}
template <int N>
Dual<N> differentiable_root(const Dual<N>& root, const VolumeCubic<Dual<N>>& cubic,
                            const Dual<N>& target) noexcept {
  const Dual<N> fixed(root.value);
  return {root.value, ((target - cubic(fixed)) / cubic.slope(fixed)).tangent};
}

}  // namespace trunk
