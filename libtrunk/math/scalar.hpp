#pragma once

#include <cmath>
#include <concepts>

namespace trunk {

/// What the kernel asks of a number. `double` is one; Lanes<W> (a parameter set a lane) and Dual<N> (a value
/// with its tangents) are others. The kernel never branches on a Scalar: comparisons give a Mask<S>, and
/// `select(mask, a, b)` takes a where the mask holds and b elsewhere.
template <class S>
concept Scalar = requires(S a, S b, double d) {
  { a + b } -> std::convertible_to<S>;
  { a - b } -> std::convertible_to<S>;
  { a* b } -> std::convertible_to<S>;
  { a / b } -> std::convertible_to<S>;
  { -a } -> std::convertible_to<S>;
  S(d);
  a < b;
};

/// The result of comparing two S: bool for a single number, a lane mask for lanes.
template <class S>
using Mask = decltype(std::declval<S>() < std::declval<S>());

template <std::floating_point S>
constexpr S select(bool mask, S a, S b) noexcept {
  return mask ? a : b;
}
constexpr bool select(bool mask, bool a, bool b) noexcept {
  return mask ? a : b;
}

/// How many simulations run side by side in one S.
template <Scalar S>
inline constexpr int lanes_of = 1;

/// The number, or the truth, in one of the lanes.
template <std::floating_point S>
constexpr double in_lane(S a, int) noexcept {
  return static_cast<double>(a);
}
constexpr bool in_lane(bool mask, int) noexcept {
  return mask;
}
template <std::floating_point S>
constexpr void set_lane(S& a, int, double value) noexcept {
  a = S(value);
}

constexpr bool any(bool mask) noexcept {
  return mask;
}
constexpr bool all(bool mask) noexcept {
  return mask;
}

/// True where the value is finite (no NaN, no infinity), without relying on the floating-point environment.
template <Scalar S>
constexpr Mask<S> finite(const S& a) noexcept {
  return (a - a) * (a - a) < S(1.0);
}

}  // namespace trunk
