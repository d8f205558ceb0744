#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "math/vec3.hpp"

namespace trunk::test {

/// SplitMix64 (Steele, Lea, Flood 2014). Ours rather than the standard library's distributions, so that a
/// test draws the same numbers with every compiler.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t bits() {
    state_ += 0x9E3779B97F4A7C15u;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }
  /// In [0, 1).
  double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  /// In [low, high).
  double between(double low, double high) { return low + (high - low) * unit(); }
  /// Of a standard normal distribution (Box and Muller 1958).
  double normal() {
    const double radius = std::sqrt(-2 * std::log(1 - unit()));
    return radius * std::cos(2 * std::numbers::pi * unit());
  }
  /// One of 0..n-1.
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(bits() % n); }
  /// Any finite double, of any size.
  double finite() {
    for (;;)
      if (const double value = std::bit_cast<double>(bits()); std::isfinite(value)) return value;
  }
  /// In a cube of half edge `size`.
  Vec3d vector(double size) {
    const double x = between(-size, size), y = between(-size, size), z = between(-size, size);
    return {x, y, z};
  }

 private:
  std::uint64_t state_;
};

}  // namespace trunk::test
