#pragma once

#include "math/scalar.hpp"

namespace trunk {

/// A point, displacement, velocity or force. Axes are right-anterior-superior (RAS): +x to the subject's
/// right, +y forward, +z up.
template <Scalar S>
class Vec3 {
 public:
  constexpr Vec3() noexcept : x_(0.0), y_(0.0), z_(0.0) {}
  constexpr Vec3(const S& x, const S& y, const S& z) noexcept : x_(x), y_(y), z_(z) {}
  // The copy goes number by number: g++ 12 would copy pieces of 16 bytes, and a later read of 32 bytes would
  // wait for them.
  constexpr Vec3(const Vec3& a) noexcept : x_(a.x_), y_(a.y_), z_(a.z_) {}
  constexpr Vec3& operator=(const Vec3& a) noexcept {
    x_ = a.x_;
    y_ = a.y_;
    z_ = a.z_;
    return *this;
  }

  constexpr S x() const noexcept { return x_; }
  constexpr S y() const noexcept { return y_; }
  constexpr S z() const noexcept { return z_; }

  friend constexpr Vec3 operator+(const Vec3& a, const Vec3& b) noexcept {
    return {a.x_ + b.x_, a.y_ + b.y_, a.z_ + b.z_};
  }
  friend constexpr Vec3 operator-(const Vec3& a, const Vec3& b) noexcept {
    return {a.x_ - b.x_, a.y_ - b.y_, a.z_ - b.z_};
  }
  friend constexpr Vec3 operator*(const S& k, const Vec3& a) noexcept {
    return {k * a.x_, k * a.y_, k * a.z_};
  }
  /// Returns the product component by component.
  friend constexpr Vec3 hadamard(const Vec3& a, const Vec3& b) noexcept {
    return {a.x_ * b.x_, a.y_ * b.y_, a.z_ * b.z_};
  }
  /// Returns (y, z, x).
  friend constexpr Vec3 turned(const Vec3& a) noexcept { return {a.y_, a.z_, a.x_}; }

 private:
  S x_, y_, z_;
};

/// The same, stored as (x, y, z, 0) in one register of 4 numbers, or in two halves where the instruction set
/// has no such register. The memory is the same, and every operation rounds as in the general form. The
/// functions that read one number are not constexpr: clang 14 cannot read a part of a register while it
/// compiles.
template <>
class alignas(4 * sizeof(double)) Vec3<double> {
 public:
  constexpr Vec3() noexcept : Vec3(0.0, 0.0, 0.0) {}
#ifdef __AVX__
  typedef double Register __attribute__((vector_size(4 * sizeof(double))));

  constexpr explicit Vec3(Register xyz0) noexcept : xyz0_(xyz0) {}
  constexpr Register bits() const noexcept {
    return xyz0_;
  }

  constexpr Vec3(double x, double y, double z) noexcept : xyz0_{x, y, z, 0.0} {}

  double x() const noexcept {
    return xyz0_[0];
  }
  double y() const noexcept {
    return xyz0_[1];
  }
  double z() const noexcept {
    return xyz0_[2];
  }

  friend constexpr Vec3 operator+(const Vec3& a, const Vec3& b) noexcept {
    return Vec3(a.xyz0_ + b.xyz0_);
  }
  friend constexpr Vec3 operator-(const Vec3& a, const Vec3& b) noexcept {
    return Vec3(a.xyz0_ - b.xyz0_);
  }
  friend constexpr Vec3 operator*(double k, const Vec3& a) noexcept {
    return Vec3(k * a.xyz0_);
  }
  friend constexpr Vec3 hadamard(const Vec3& a, const Vec3& b) noexcept {
    return Vec3(a.xyz0_ * b.xyz0_);
  }
  friend Vec3 turned(const Vec3& a) noexcept {
    return Vec3(__builtin_shufflevector(a.xyz0_, a.xyz0_, 1, 2, 0, 3));
  }

 private:
  Register xyz0_;
#else
  typedef double Register __attribute__((vector_size(2 * sizeof(double))));

  constexpr Vec3(Register xy, Register z0) noexcept : xy_(xy), z0_(z0) {}
  constexpr Vec3(double x, double y, double z) noexcept : xy_{x, y}, z0_{z, 0.0} {}

  double x() const noexcept {
    return xy_[0];
  }
  double y() const noexcept {
    return xy_[1];
  }
  double z() const noexcept {
    return z0_[0];
  }

  friend constexpr Vec3 operator+(const Vec3& a, const Vec3& b) noexcept {
    return {a.xy_ + b.xy_, a.z0_ + b.z0_};
  }
  friend constexpr Vec3 operator-(const Vec3& a, const Vec3& b) noexcept {
    return {a.xy_ - b.xy_, a.z0_ - b.z0_};
  }
  friend constexpr Vec3 operator*(double k, const Vec3& a) noexcept {
    return {k * a.xy_, k * a.z0_};
  }
  friend constexpr Vec3 hadamard(const Vec3& a, const Vec3& b) noexcept {
    return {a.xy_ * b.xy_, a.z0_ * b.z0_};
  }
  friend Vec3 turned(const Vec3& a) noexcept {
    return {__builtin_shufflevector(a.xy_, a.z0_, 1, 2), __builtin_shufflevector(a.xy_, a.z0_, 0, 3)};
  }

 private:
  Register xy_, z0_;
#endif
};

using Vec3d = Vec3<double>;

template <Scalar S>
constexpr Vec3<S>& operator+=(Vec3<S>& a, const Vec3<S>& b) noexcept {
  return a = a + b;
}
template <Scalar S>
constexpr Vec3<S>& operator-=(Vec3<S>& a, const Vec3<S>& b) noexcept {
  return a = a - b;
}

template <Scalar S>
constexpr S dot(const Vec3<S>& a, const Vec3<S>& b) noexcept {
  const Vec3<S> p = hadamard(a, b);
  return p.x() + p.y() + p.z();
}

/// Returns a vector whose turned() is a x b. A sum of cross products is thus turned only once, at its end.
template <Scalar S>
constexpr Vec3<S> unturned_cross(const Vec3<S>& a, const Vec3<S>& b) noexcept {
  return hadamard(a, turned(b)) - hadamard(turned(a), b);
}
template <Scalar S>
constexpr Vec3<S> cross(const Vec3<S>& a, const Vec3<S>& b) noexcept {
  return turned(unturned_cross(a, b));
}

template <Scalar S>
S norm(const Vec3<S>& a) noexcept {
  using std::sqrt;
  return sqrt(dot(a, a));
}

/// Returns a where the mask is true and b elsewhere.
template <Scalar S>
constexpr Vec3<S> select(const Mask<S>& mask, const Vec3<S>& a, const Vec3<S>& b) noexcept {
  return {select(mask, a.x(), b.x()), select(mask, a.y(), b.y()), select(mask, a.z(), b.z())};
}
constexpr Vec3d select(bool mask, const Vec3d& a, const Vec3d& b) noexcept {
  return mask ? a : b;
}

/// Returns a constant of the model as a value of the kernel's scalar.
template <Scalar S>
constexpr Vec3<S> lift(const Vec3d& a) noexcept {
  return {S(a.x()), S(a.y()), S(a.z())};
}
template <>
constexpr Vec3d lift<double>(const Vec3d& a) noexcept {
  return a;
}

/// Returns a vector of the kernel times a constant of the model, component by component: held axes have
/// weight 0.
template <Scalar S>
constexpr Vec3<S> scaled(const Vec3d& weight, const Vec3<S>& a) noexcept {
  return hadamard(lift<S>(weight), a);
}

}  // namespace trunk
