#pragma once

#include "math/vec3.hpp"

namespace trunk {

/// Four numbers in one register, every operation on all of them at once, rounding as double does.
template <class T, int W>
struct LaneRegister {  // the element type must be a parameter, or g++ drops the attribute
  typedef T Type __attribute__((vector_size(W * sizeof(T))));
};

class Lanes4 {
 public:
  using Register = LaneRegister<double, 4>::Type;

  constexpr Lanes4() noexcept : r_{0.0, 0.0, 0.0, 0.0} {}
  constexpr explicit Lanes4(double a) noexcept : r_{a, a, a, a} {}
  constexpr explicit Lanes4(Register r) noexcept : r_(r) {}
  constexpr Lanes4(double a, double b, double c, double d) noexcept : r_{a, b, c, d} {}

  constexpr double operator[](int lane) const noexcept { return r_[lane]; }
  constexpr Register bits() const noexcept { return r_; }

  friend constexpr Lanes4 operator+(Lanes4 a, Lanes4 b) noexcept { return Lanes4(a.r_ + b.r_); }
  friend constexpr Lanes4 operator-(Lanes4 a, Lanes4 b) noexcept { return Lanes4(a.r_ - b.r_); }
  friend constexpr Lanes4 operator*(Lanes4 a, Lanes4 b) noexcept { return Lanes4(a.r_ * b.r_); }
  friend constexpr Lanes4 operator/(Lanes4 a, Lanes4 b) noexcept { return Lanes4(a.r_ / b.r_); }
  friend constexpr Lanes4 operator-(Lanes4 a) noexcept { return Lanes4(-a.r_); }
  friend constexpr auto operator<(Lanes4 a, Lanes4 b) noexcept { return a.r_ < b.r_; }
  friend Lanes4 sqrt(Lanes4 a) noexcept {
    return {std::sqrt(a.r_[0]), std::sqrt(a.r_[1]), std::sqrt(a.r_[2]), std::sqrt(a.r_[3])};
  }

 private:
  Register r_;
};

/// Four vectors as one vector of lanes, and back: a transposition of (x, y, z, 0) rows.
constexpr Vec3<Lanes4> packed(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) noexcept {
  const auto ab02 = __builtin_shufflevector(a.bits(), b.bits(), 0, 4, 2, 6);
  const auto ab13 = __builtin_shufflevector(a.bits(), b.bits(), 1, 5, 3, 7);
  const auto cd02 = __builtin_shufflevector(c.bits(), d.bits(), 0, 4, 2, 6);
  const auto cd13 = __builtin_shufflevector(c.bits(), d.bits(), 1, 5, 3, 7);
  return {Lanes4(__builtin_shufflevector(ab02, cd02, 0, 1, 4, 5)),
          Lanes4(__builtin_shufflevector(ab13, cd13, 0, 1, 4, 5)),
          Lanes4(__builtin_shufflevector(ab02, cd02, 2, 3, 6, 7))};
}

struct Unpacked {
  Vec3d lane[4];
};
constexpr Unpacked unpacked(const Vec3<Lanes4>& v) noexcept {
  const auto x = v.x().bits(), y = v.y().bits(), z = v.z().bits();
  const auto none = Lanes4().bits();
  const auto xy02 = __builtin_shufflevector(x, y, 0, 4, 2, 6),
             xy13 = __builtin_shufflevector(x, y, 1, 5, 3, 7);
  const auto z02 = __builtin_shufflevector(z, none, 0, 4, 2, 6),
             z13 = __builtin_shufflevector(z, none, 1, 5, 3, 7);
  return {Vec3d(__builtin_shufflevector(xy02, z02, 0, 1, 4, 5)),
          Vec3d(__builtin_shufflevector(xy13, z13, 0, 1, 4, 5)),
          Vec3d(__builtin_shufflevector(xy02, z02, 2, 3, 6, 7)),
          Vec3d(__builtin_shufflevector(xy13, z13, 2, 3, 6, 7))};
}

}  // namespace trunk
