#pragma once

#include <cmath>
#include <concepts>

namespace trunk {

/// What the kernel asks of a number. `double` is one; SIMD lanes (one parameter set a lane) and dual numbers
/// (a value with its tangents) are written to be others. The kernel never branches on a Scalar: comparisons
/// give a Mask<S>, and `select(mask, a, b)` takes a where the mask holds and b elsewhere.
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
