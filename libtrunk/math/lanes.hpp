#pragma once

#include <cstdint>

#include "math/vec3.hpp"

namespace trunk {

template <class T, int W>
struct LaneRegister {  // the element type must be a parameter, or g++ drops the attribute
  typedef T Type __attribute__((vector_size(W * sizeof(T)), aligned(W * sizeof(T))));
};

/// One bool in each lane: the result of comparing two Lanes<W>.
template <int W>
class LaneMask {
 public:
  using Register = typename LaneRegister<std::int64_t, W>::Type;  // all bits of a lane are set, or none

  constexpr LaneMask() noexcept : r_{} {}
  constexpr explicit LaneMask(Register r) noexcept : r_(r) {}

  constexpr Register bits() const noexcept { return r_; }

  friend constexpr LaneMask operator&(LaneMask a, LaneMask b) noexcept { return LaneMask(a.r_ & b.r_); }
  friend constexpr LaneMask operator|(LaneMask a, LaneMask b) noexcept { return LaneMask(a.r_ | b.r_); }
  friend constexpr LaneMask operator==(LaneMask a, LaneMask b) noexcept { return LaneMask(~(a.r_ ^ b.r_)); }
  friend constexpr LaneMask operator!(LaneMask a) noexcept { return LaneMask(~a.r_); }
  friend constexpr LaneMask select(LaneMask mask, LaneMask a, LaneMask b) noexcept {
    return LaneMask(mask.r_ ? a.r_ : b.r_);
  }
  friend constexpr bool in_lane(LaneMask a, int lane) noexcept { return a.r_[lane] != 0; }
  friend constexpr bool any(LaneMask a) noexcept {
    std::int64_t found = 0;
    for (int i = 0; i < W; ++i) found |= a.r_[i];
    return found != 0;
  }
  friend constexpr bool all(LaneMask a) noexcept { return !any(!a); }

 private:
  Register r_;
};

/// W numbers in one register. Every operation acts on all of them at once and rounds each as a double.
template <int W>
class Lanes {
 public:
  using Register = typename LaneRegister<double, W>::Type;

  constexpr Lanes() noexcept : r_{} {}
  constexpr explicit Lanes(double a) noexcept : r_{} { r_ += a; }
  constexpr explicit Lanes(Register r) noexcept : r_(r) {}

  constexpr Register bits() const noexcept { return r_; }

  friend constexpr Lanes operator+(Lanes a, Lanes b) noexcept { return Lanes(a.r_ + b.r_); }
  friend constexpr Lanes operator-(Lanes a, Lanes b) noexcept { return Lanes(a.r_ - b.r_); }
  friend constexpr Lanes operator*(Lanes a, Lanes b) noexcept { return Lanes(a.r_ * b.r_); }
  friend constexpr Lanes operator/(Lanes a, Lanes b) noexcept { return Lanes(a.r_ / b.r_); }
  friend constexpr Lanes operator-(Lanes a) noexcept { return Lanes(-a.r_); }
  friend constexpr LaneMask<W> operator<(Lanes a, Lanes b) noexcept { return LaneMask<W>(a.r_ < b.r_); }
  friend constexpr Lanes select(LaneMask<W> mask, Lanes a, Lanes b) noexcept {
    return Lanes(mask.bits() ? a.r_ : b.r_);
  }
  friend Lanes sqrt(Lanes a) noexcept {
    for (int i = 0; i < W; ++i) a.r_[i] = std::sqrt(a.r_[i]);
    return a;
  }
  friend Lanes floor(Lanes a) noexcept {
    for (int i = 0; i < W; ++i) a.r_[i] = std::floor(a.r_[i]);
    return a;
  }
  friend constexpr double in_lane(Lanes a, int lane) noexcept { return a.r_[lane]; }
  friend constexpr void set_lane(Lanes& a, int lane, double value) noexcept { a.r_[lane] = value; }

 private:
  Register r_;
};

template <int W>
inline constexpr int lanes_of<Lanes<W>> = W;

#ifdef __AVX__
/// Returns four vectors as one vector of lanes: it transposes the rows (x, y, z, 0). `unpacked` undoes it.
inline Vec3<Lanes<4>> packed(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) noexcept {
  const auto ab02 = __builtin_shufflevector(a.bits(), b.bits(), 0, 4, 2, 6);
  const auto ab13 = __builtin_shufflevector(a.bits(), b.bits(), 1, 5, 3, 7);
  const auto cd02 = __builtin_shufflevector(c.bits(), d.bits(), 0, 4, 2, 6);
  const auto cd13 = __builtin_shufflevector(c.bits(), d.bits(), 1, 5, 3, 7);
  return {Lanes<4>(__builtin_shufflevector(ab02, cd02, 0, 1, 4, 5)),
          Lanes<4>(__builtin_shufflevector(ab13, cd13, 0, 1, 4, 5)),
          Lanes<4>(__builtin_shufflevector(ab02, cd02, 2, 3, 6, 7))};
}

struct Unpacked {
  Vec3d lane[4];
};
inline Unpacked unpacked(const Vec3<Lanes<4>>& v) noexcept {
  const auto x = v.x().bits(), y = v.y().bits(), z = v.z().bits();
  const auto none = Lanes<4>().bits();
  const auto xy02 = __builtin_shufflevector(x, y, 0, 4, 2, 6),
             xy13 = __builtin_shufflevector(x, y, 1, 5, 3, 7);
  const auto z02 = __builtin_shufflevector(z, none, 0, 4, 2, 6),
             z13 = __builtin_shufflevector(z, none, 1, 5, 3, 7);
  return {Vec3d(__builtin_shufflevector(xy02, z02, 0, 1, 4, 5)),
          Vec3d(__builtin_shufflevector(xy13, z13, 0, 1, 4, 5)),
          Vec3d(__builtin_shufflevector(xy02, z02, 2, 3, 6, 7)),
          Vec3d(__builtin_shufflevector(xy13, z13, 2, 3, 6, 7))};
}
#endif

}  // namespace trunk
