/// @file
/// How much the operations of a rigid body round, and bodies to try them on.
#pragma once

#include <support/random_quaternion.hpp>
#include <tumble/make_rigid_body.hpp>
#include <tumble/spheres.hpp>

namespace tumble::support {

/// How far rotate() may be off, relative to the vector's length.
///
/// q has norm 1 within 4 roundings, which counts twice. A component of 2 u × v is off by 6
/// roundings of |v|; w times it by 8, u times it by 12; the two sums add 6. That makes 34; 40 is
/// round.
template <class Real>
constexpr Real rotation_error = 40 * unit_roundoff<Real>;

/// How far an element of R D Rᵀ may be off, relative to the largest element of D: R's elements are
/// off by 16 roundings each (the norm of q twice, and 8 of their own), on both sides, and each of
/// nine products adds two roundings of at most a third.
template <class Real>
constexpr Real tensor_error = (2 * 3 * 16 + 9 * 2) * unit_roundoff<Real>;

/// A brick of 2 kg that resists differently about each axis, at a random place and orientation,
/// moving and turning.
template <class Real>
RigidBody<Real> random_brick(std::mt19937_64& generator) {
  const MassProperties<Real> brick = mass_properties(Box<Real>{Vec3<Real>(1, 2, 3)}, 2);
  const Pose<Real> pose{random_vector<Real>(generator), random_orientation<Real>(generator)};
  const Vec3<Real> velocity = random_vector<Real>(generator), spin = random_vector<Real>(generator);
  return make_rigid_body("brick", brick, pose, velocity, spin).body;
}

}  // namespace tumble::support
