#pragma once

#include <cmath>
#include <concepts>

namespace trunk {

/// What the kernel needs of a type of number. `double` is a Scalar, and so are Lanes<W> (one parameter set in
/// each lane) and Dual<N> (a value with its tangents). The kernel never branches on a Scalar: a comparison
/// gives a Mask<S>, and `select(mask, a, b)` takes a where the mask is true and b elsewhere.
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

/// The number of simulations that run side by side in one S.
template <Scalar S>
inline constexpr int lanes_of = 1;

/// Returns the number, or the bool, in one of the lanes.
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

/// Returns true where the value is finite (no NaN, no infinity). It does not rely on the floating-point
/// environment.
template <Scalar S>
constexpr Mask<S> finite(const S& a) noexcept {
  return (a - a) * (a - a) < S(1.0);
}

}  // namespace trunk
