/// @file
/// Quaternions: four numbers with a product, and the unit ones as orientations.
#pragma once

#include <limits>
#include <tumble/require.hpp>

namespace tumble {

/// w + x i + y j + z k, with i² = j² = k² = ijk = −1: a real number and a vector in one.
///
/// One of norm 1 stands for an orientation: rotate() then takes vectors from the body's axes to
/// the world's. By default it turns nothing.
//! [quaternion]
template <class Real>
struct Quaternion {
  Real real = 1;                              ///< w
  Vec3<Real> imaginary = Vec3<Real>::Zero();  ///< along i, j and k
};
//! [quaternion]

using Quaternionf = Quaternion<float>;
using Quaterniond = Quaternion<double>;

/// A vector as a quaternion: its real part is zero.
template <class Real>
Quaternion<Real> pure(const Vec3<Real>& vector) {
  return {.real = 0, .imaginary = vector};
}

/// Number by number; a sum of two orientations is none.
template <class Real>
Quaternion<Real> operator+(const Quaternion<Real>& p, const Quaternion<Real>& q) {
  return {.real = p.real + q.real, .imaginary = p.imaginary + q.imaginary};
}

/// All four numbers with the other sign: the same orientation.
template <class Real>
Quaternion<Real> operator-(const Quaternion<Real>& q) {
  return {.real = -q.real, .imaginary = -q.imaginary};
}

/// Each of the four numbers times the factor.
template <class Real>
Quaternion<Real> operator*(Same<Real> factor, const Quaternion<Real>& q) {
  return {.real = factor * q.real, .imaginary = factor * q.imaginary};
}

/// The product of two quaternions. As orientations: first the turn q, then the turn p, both about
/// the world's axes.
//! [product]
template <class Real>
Quaternion<Real> operator*(const Quaternion<Real>& p, const Quaternion<Real>& q) {
  const Vec3<Real>& u = p.imaginary;
  const Vec3<Real>& v = q.imaginary;
  return {p.real * q.real - dot(u, v), p.real * v + q.real * u + u.cross(v)};
}
//! [product]

/// w − x i − y j − z k: for an orientation, the turn back.
//! [conjugate]
template <class Real>
Quaternion<Real> conjugate(const Quaternion<Real>& q) {
  return {.real = q.real, .imaginary = -q.imaginary};
}
//! [conjugate]

/// The length √(w² + x² + y² + z²). That of a product is the product of both: |pq| = |p| |q|.
//! [norm]
template <class Real>
Real norm(const Quaternion<Real>& q) {
  using std::sqrt;
  return sqrt(q.real * q.real + q.imaginary.squaredNorm());
}

/// The quaternion of norm 1 in the same direction. Of zero it makes NaN: input is checked by
/// checked_orientation(), where it enters.
template <class Real>
Quaternion<Real> normalized(const Quaternion<Real>& q) {
  return (1 / norm(q)) * q;
}
//! [norm]

/// The quaternion of norm 1 in the same direction, for one that is nearly so: if all that its norm
/// misses is rounding, it is returned as it is, to the bit.
///
/// What normalized() returns is off by 5 roundings at most, its square by twice as many, and to sum
/// the four squares takes 4 more: 14 in all, where 8 epsilon are 16.
//! [renormalized]
template <class Real>
Quaternion<Real> renormalized(const Quaternion<Real>& q) {
  using std::abs, std::sqrt;
  const Real square = q.real * q.real + q.imaginary.squaredNorm();
  const auto near_enough = abs(square - 1) <= 8 * std::numeric_limits<Real>::epsilon();
  return select(near_enough, Real(1), 1 / sqrt(square)) * q;
}
//! [renormalized]

/// q v q*: the vector in world axes whose components in body axes are `vector`, when q is the
/// body's orientation. `q` must have norm 1.
///
/// With u the imaginary part, q v q* = (w² − u·u) v + 2 (u·v) u + 2 w u × v. Where w² = 1 − u·u,
/// that is v + 2 w (u × v) + 2 u × (u × v).
//! [rotate]
template <class Real>
Vec3<Real> rotate(const Quaternion<Real>& q, const Vec3<Same<Real>>& vector) {
  const Vec3<Real> twice = 2 * q.imaginary.cross(vector);
  return vector + q.real * twice + q.imaginary.cross(twice);
}

/// q* v q: the way back, from world axes to body axes. `q` must have norm 1.
template <class Real>
Vec3<Real> rotate_back(const Quaternion<Real>& q, const Vec3<Same<Real>>& vector) {
  return rotate(conjugate(q), vector);
}
//! [rotate]

/// A quaternion as "(w, x, y, z)".
template <class Real>
std::string text_of(const Quaternion<Real>& q) {
  std::string text = "(";
  text.append(text_of(q.real));
  for (int axis = 0; axis < 3; ++axis) text.append(", ").append(text_of(q.imaginary[axis]));
  return text.append(")");
}

/// The orientation `q`, normalised, if its norm is within 0.01 of 1: four numbers rounded to two
/// digits after the point are that close. `name` is what the error calls it.
/// @throws std::invalid_argument if a component is not finite, all four are zero, or the norm is
/// further off.
//! [checked_orientation]
template <class Real>
Quaternion<Real> checked_orientation(const Quaternion<Real>& q, std::string_view name) {
  if (!std::isfinite(q.real) || !is_finite(q.imaginary))
    reject(name, q, "", "every component must be finite");
  if (q.real == 0 && (q.imaginary.array() == 0).all())
    reject(name, q, "", "zero turns nothing into nothing: no turn is (1, 0, 0, 0)");
  if (!(std::abs(norm(q) - 1) <= Real(0.01))) {
    const Vec3<Real>& u = q.imaginary;  // whose squares may be 0 or infinite, unlike the norm
    const Real length = std::hypot(q.real, std::hypot(u.x(), u.y(), u.z()));
    reject(name, q, "", "its norm is " + text_of(length) + " and must be 1 within 0.01");
  }
  return normalized(q);
}
//! [checked_orientation]

}  // namespace tumble
