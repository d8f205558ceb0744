#pragma once

#include "math/lanes.hpp"

namespace trunk {

/// A value and its derivatives along N directions. The derivatives are exact but for round-off: the tangents
/// follow the value through every operation. Comparisons look at the value alone, and the value has the same
/// bits as a double would have.
template <int N>
struct Dual {
  double value = 0.0;
  Lanes<N> tangent;  // one register: with an array, g++ 12 makes code that does twice the work

  constexpr Dual() noexcept = default;
  constexpr explicit Dual(double v) noexcept : value(v) {}
  constexpr Dual(double v, Lanes<N> t) noexcept : value(v), tangent(t) {}

  // The copy goes number by number, as in Vec3.
  constexpr Dual(const Dual& a) noexcept : value(a.value), tangent(a.tangent) {}
  constexpr Dual& operator=(const Dual& a) noexcept {
    value = a.value;
    tangent = a.tangent;
    return *this;
  }

  friend constexpr Dual operator+(const Dual& a, const Dual& b) noexcept {
    return {a.value + b.value, a.tangent + b.tangent};
  }
  friend constexpr Dual operator-(const Dual& a, const Dual& b) noexcept {
    return {a.value - b.value, a.tangent - b.tangent};
  }
  friend constexpr Dual operator-(const Dual& a) noexcept { return {-a.value, -a.tangent}; }
  friend constexpr Dual operator*(const Dual& a, const Dual& b) noexcept {
    return {a.value * b.value, Lanes<N>(a.value) * b.tangent + Lanes<N>(b.value) * a.tangent};
  }
  friend constexpr Dual operator/(const Dual& a, const Dual& b) noexcept {
    const double quotient = a.value / b.value;
    return {quotient, Lanes<N>(1.0 / b.value) * (a.tangent - Lanes<N>(quotient) * b.tangent)};
  }
  friend Dual sqrt(const Dual& a) noexcept {
    const double root = std::sqrt(a.value);
    return {root, Lanes<N>(0.5 / root) * a.tangent};
  }
  friend Dual floor(const Dual& a) noexcept { return Dual(std::floor(a.value)); }

  friend constexpr bool operator<(const Dual& a, const Dual& b) noexcept { return a.value < b.value; }
  friend constexpr Dual select(bool mask, const Dual& a, const Dual& b) noexcept { return mask ? a : b; }
  friend constexpr double in_lane(const Dual& a, int) noexcept { return a.value; }
  friend constexpr void set_lane(Dual& a, int, double v) noexcept { a = Dual(v); }
};

}  // namespace trunk
