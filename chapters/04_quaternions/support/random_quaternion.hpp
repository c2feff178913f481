/// @file
/// Vectors and quaternions drawn at random, the same in every precision and on every machine.
#pragma once

#include <random>
#include <support/checks.hpp>
#include <tumble/quaternion.hpp>

namespace tumble::support {

/// Between -1 and 1.
template <class Real>
Real random_number(std::mt19937_64& generator) {
  return static_cast<Real>(std::ldexp(static_cast<double>(generator() >> 11), -52) - 1);
}

/// Each component between -1 and 1.
template <class Real>
Vec3<Real> random_vector(std::mt19937_64& generator) {
  const Real x = random_number<Real>(generator), y = random_number<Real>(generator),
             z = random_number<Real>(generator);
  return {x, y, z};
}

/// Each component between -1 and 1.
template <class Real>
Quaternion<Real> random_quaternion(std::mt19937_64& generator) {
  const Real real = random_number<Real>(generator);
  return {.real = real, .imaginary = random_vector<Real>(generator)};
}

/// Any orientation, each as likely as the next: a point of the ball of radius 1 in four dimensions,
/// moved out to its surface.
template <class Real>
Quaternion<Real> random_orientation(std::mt19937_64& generator) {
  Quaternion<Real> q = random_quaternion<Real>(generator);
  while (norm(q) > 1 || norm(q) < Real(0.125)) q = random_quaternion<Real>(generator);
  return normalized(q);
}

/// The same number in another precision.
template <class To, class From>
Quaternion<To> cast(const Quaternion<From>& q) {
  return {.real = static_cast<To>(q.real), .imaginary = q.imaginary.template cast<To>()};
}

/// The largest absolute component of a difference.
template <class Real>
Real distance(const Quaternion<Real>& p, const Quaternion<Real>& q) {
  return std::max(std::abs(p.real - q.real), distance(p.imaginary, q.imaginary));
}

/// True when all bits agree (and no component is NaN).
template <class Real>
bool same_bits(const Quaternion<Real>& p, const Quaternion<Real>& q) {
  return p.real == q.real && same_bits(p.imaginary, q.imaginary);
}

}  // namespace tumble::support
