#pragma once

#include "math/vec3.hpp"

namespace trunk {

/// A rotation as a unit quaternion (w, v).
template <Scalar S>
struct Rotation {
  S w{1.0};
  Vec3<S> v;
};

/// Returns the rotated vector.
template <Scalar S>
Vec3<S> turn(const Rotation<S>& r, const Vec3<S>& a) noexcept {
  const Vec3<S> half = cross(r.v, a) + r.w * a;
  return a + S(2.0) * cross(r.v, half);
}

/// Returns the vector rotated back.
template <Scalar S>
Vec3<S> turn_back(const Rotation<S>& r, const Vec3<S>& a) noexcept {
  return turn(Rotation<S>{r.w, S(-1.0) * r.v}, a);
}

/// Returns the rotation `first` followed by `second`, scaled back to unit length so that round-off does not
/// add up.
template <Scalar S>
Rotation<S> then(const Rotation<S>& first, const Rotation<S>& second) noexcept {
  using std::sqrt;
  const Rotation<S> p{second.w * first.w - dot(second.v, first.v),
                      second.w * first.v + first.w * second.v + cross(second.v, first.v)};
  const S inverse_length = S(1.0) / sqrt(p.w * p.w + dot(p.v, p.v));
  return {inverse_length * p.w, inverse_length * p.v};
}

/// Returns the rotation by about |angle| rad around the direction of `angle` (Cayley transform). It is a
/// rotation for any angle, its angle is wrong by |angle|^3 / 12, and it needs no trigonometry.
template <Scalar S>
Rotation<S> small_rotation(const Vec3<S>& angle) noexcept {
  using std::sqrt;
  const S w = S(1.0) / sqrt(S(1.0) + S(0.25) * dot(angle, angle));
  return {w, (S(0.5) * w) * angle};
}

/// Returns the rotation by `angle` rad around a unit vector, counter-clockwise seen from its tip.
inline Rotation<double> rotation_about(const Vec3d& axis, double angle) noexcept {
  return {std::cos(0.5 * angle), std::sin(0.5 * angle) * axis};
}

template <Scalar S>
Rotation<S> lift(const Rotation<double>& r) noexcept {
  return {S(r.w), lift<S>(r.v)};
}

}  // namespace trunk
