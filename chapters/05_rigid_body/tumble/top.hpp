/// @file
/// A top: all that turns about the centre of mass, in the axes in which its inertia is three
/// numbers.
#pragma once

#include <tumble/inertia.hpp>
#include <tumble/rotation_matrix.hpp>

namespace tumble {

/// What turns about a centre of mass. The body axes are the principal axes, so that the inertia is
/// three numbers; the two with the closest inverse moments come first, which chapter 8 makes use
/// of.
//! [top]
template <class Real>
struct Top {
  Quaternion<Real> orientation = {};                      ///< from body axes to world axes
  Vec3<Real> angular_momentum_body = Vec3<Real>::Zero();  ///< kg m²/s, body axes
  Vec3<Real> torque = Vec3<Real>::Zero();                 ///< this step's sum, N m, world axes
  Vec3<Real> inverse_moments = Vec3<Real>::Zero();        ///< 1/(kg m²); 0: locked about that axis
};
//! [top]

using Topf = Top<float>;
using Topd = Top<double>;

/// A vector given in body axes without its parts along locked axes: what can turn the body.
//! [free_part]
template <class Real>
Vec3<Real> free_part(const Top<Real>& top, const Vec3<Same<Real>>& vector_body) {
  const Vec3<Real>& inverse = top.inverse_moments;
  return {select(inverse.x() == 0, Real(0), vector_body.x()),
          select(inverse.y() == 0, Real(0), vector_body.y()),
          select(inverse.z() == 0, Real(0), vector_body.z())};
}
//! [free_part]

/// The principal moments, kg m², body axes; 0 about a locked axis, which no formula may divide by.
template <class Real>
Vec3<Real> moments_of(const Top<Real>& top) {
  return free_part<Real>(top, top.inverse_moments.cwiseInverse());
}

/// Locks the turning about one body axis (0, 1 or 2): the top no longer turns about it, its angular
/// momentum about it is 0, and torque about it is borne by whatever does the locking. Body axes are
/// the principal axes in the order that make_rigid_body() gives them, not the model's. The model's
/// z axis is rotate(model_in_body.orientation, {0, 0, 1}) in them: lock the component that is ±1.
/// A line that is no principal axis can't be locked so.
template <class Real>
void lock_axis(Top<Real>& top, int axis) {
  top.inverse_moments[axis] = 0;
  top.angular_momentum_body[axis] = 0;
}

/// ω = I⁻¹ L in body axes, rad/s.
//! [angular_velocity]
template <class Real>
Vec3<Real> angular_velocity_body(const Top<Real>& top) {
  return top.inverse_moments.cwiseProduct(top.angular_momentum_body);
}

/// The same in world axes, rad/s.
template <class Real>
Vec3<Real> angular_velocity_world(const Top<Real>& top) {
  return rotate(top.orientation, angular_velocity_body(top));
}
//! [angular_velocity]

/// Sets the angular momentum to that of turning with ω (rad/s, body axes): L = I ω. About a locked
/// axis it stays 0.
template <class Real>
void set_angular_velocity_body(Top<Real>& top, const Vec3<Same<Real>>& angular_velocity) {
  top.angular_momentum_body = moments_of(top).cwiseProduct(angular_velocity);
}

/// Sets the angular momentum to that of turning with ω (rad/s, world axes).
template <class Real>
void set_angular_velocity_world(Top<Real>& top, const Vec3<Same<Real>>& angular_velocity) {
  set_angular_velocity_body(top, rotate_back(top.orientation, angular_velocity));
}

/// L in world axes, kg m²/s: what stays constant while no torque acts.
template <class Real>
Vec3<Real> angular_momentum_world(const Top<Real>& top) {
  return rotate(top.orientation, top.angular_momentum_body);
}

/// Sets L, kg m²/s, world axes. About a locked axis it stays 0.
template <class Real>
void set_angular_momentum_world(Top<Real>& top, const Vec3<Same<Real>>& angular_momentum) {
  top.angular_momentum_body = free_part(top, rotate_back(top.orientation, angular_momentum));
}

/// I⁻¹ v for a vector in world axes: rotate in, divide by the moments, rotate out. With a torque it
/// is the angular acceleration of a top at rest, rad/s².
//! [inverse_inertia_times]
template <class Real>
Vec3<Real> inverse_inertia_times(const Top<Real>& top, const Vec3<Same<Real>>& vector_world) {
  const Vec3<Real> vector_body = rotate_back(top.orientation, vector_world);
  return rotate<Real>(top.orientation, top.inverse_moments.cwiseProduct(vector_body));
}
//! [inverse_inertia_times]

/// The inverse inertia tensor in world axes, R I⁻¹ Rᵀ, 1/(kg m²). To show and to test: a step works
/// in body axes, where the tensor is three numbers and loses none of them.
template <class Real>
Mat3<Real> world_inverse_inertia(const Top<Real>& top) {
  const Mat3<Real> R = matrix_of(top.orientation);
  return R * top.inverse_moments.asDiagonal() * R.transpose();
}

/// The inertia tensor in world axes, R I Rᵀ, kg m². A locked axis counts as 0.
template <class Real>
Mat3<Real> world_inertia(const Top<Real>& top) {
  const Mat3<Real> R = matrix_of(top.orientation);
  return R * moments_of(top).asDiagonal() * R.transpose();
}

/// Adds `torque` (N m, world axes) to what already acts in this step.
/// @throws std::invalid_argument if it is not finite; the top is then unchanged.
template <class Real>
void add_torque(Top<Real>& top, const Vec3<Same<Real>>& torque) {
  require_finite("torque", torque, "N m");
  top.torque += torque;
}

/// Empties the accumulator. Call it exactly once in every step.
template <class Real>
void clear_torque(Top<Real>& top) {
  top.torque.setZero();
}

/// A sudden change of the angular momentum by `angular_impulse` (N m s, world axes): a torque times
/// the short time that it lasts. The part about a locked axis is borne by whatever locks it.
template <class Real>
void add_angular_momentum(Top<Real>& top, const Vec3<Same<Real>>& angular_impulse) {
  const Vec3<Real> change_body = rotate_back(top.orientation, angular_impulse);
  top.angular_momentum_body += free_part(top, change_body);
}

/// The energy of turning, ½ L · I⁻¹ L, in J.
template <class Real>
Real kinetic_energy(const Top<Real>& top) {
  return dot(angular_velocity_body(top), top.angular_momentum_body) / 2;
}

}  // namespace tumble
