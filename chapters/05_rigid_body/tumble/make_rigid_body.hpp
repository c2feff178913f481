/// @file
/// From a shape's mass properties to a body that can be stepped, and to where its model is drawn.
#pragma once

#include <tumble/rigid_body.hpp>
#include <tumble/validate_inertia.hpp>

namespace tumble {

/// How a body may turn.
//! [turning]
enum class Turning {
  free,               ///< about every axis; each needs a moment that can be inverted
  locked_where_thin,  ///< not about axes without inertia: the line of a rod, every axis of a point
  locked              ///< not at all
};
//! [turning]

/// A body, and what a renderer needs to draw its model: the constant pose of the model's axes in
/// the body's.
template <class Real>
struct ModelledBody {
  RigidBody<Real> body;
  Pose<Real> model_in_body;
};

/// The order of three ascending moments' axes that puts the two closest inverse moments first. Both
/// orders are cyclic, so right-handed axes stay right-handed.
template <class Real>
std::array<int, 3> closest_pair_first(const Vec3<Real>& inverse_moments) {
  const Real first_gap = std::abs(inverse_moments(0) - inverse_moments(1));
  const Real second_gap = std::abs(inverse_moments(1) - inverse_moments(2));
  return first_gap <= second_gap ? std::array{0, 1, 2} : std::array{1, 2, 0};
}

/// The inverse of three principal moments, 1/(kg m²), where the body may turn, and 0 where not.
/// @throws std::invalid_argument if a moment that is needed can't be inverted.
template <class Real>
Vec3<Real> free_inverse_moments(std::string_view name, const Mat3<Real>& inertia,
                                const PrincipalAxes<Real>& principal, Turning turning) {
  if (turning == Turning::locked) return Vec3<Real>::Zero();
  if (turning == Turning::free) require_invertible_moments(name, inertia, principal);
  const Vec3<Real> rounding = moment_slack<Real>(inertia, principal.axes, element_slack<Real>);
  const Real smallest = std::numeric_limits<Real>::min();
  Vec3<Real> inverse = Vec3<Real>::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    const Real moment = principal.moments(axis);
    if (!(moment > rounding(axis))) continue;
    require_between(std::string(name) + ": principal moment", moment, "kg m^2", smallest,
                    1 / smallest);
    inverse(axis) = 1 / moment;
  }
  return inverse;
}

/// Sets the angular velocity (rad/s, world axes) of the body called `name`.
/// @throws std::invalid_argument if it is not finite, if the momentum that belongs to it is not, or
/// if it has a part about a locked axis, more than 64 roundings make of it.
template <class Real>
void set_checked_angular_velocity(std::string_view name, Top<Real>& top,
                                  const Vec3<Same<Real>>& angular_velocity) {
  const std::string prefix(name);
  require_finite(prefix + ": angular velocity", angular_velocity, "rad/s");
  set_angular_velocity_world(top, angular_velocity);
  require_finite(prefix + ": angular momentum", top.angular_momentum_body, "kg m^2/s");
  const Real slack = 64 * (std::numeric_limits<Real>::epsilon() / 2) * angular_velocity.norm();
  const Vec3<Real> in_body = rotate_back(top.orientation, angular_velocity);
  if ((in_body - free_part(top, in_body)).norm() > slack)
    reject(prefix + ": angular velocity", angular_velocity, "rad/s",
           "the body is locked about an axis that this turns about");
}

/// A body with the mass properties of a model whose own axes stand in the world as `model_in_world`
/// says. The centre of mass moves with `velocity` (m/s) and the body turns with `angular_velocity`
/// (rad/s), both in world axes.
///
/// @throws std::invalid_argument with a sentence about `name` if no body can have these mass
/// properties, or not with all digits in `Real`; if an axis that should turn has no inertia; if a
/// number, the angular momentum or the place of the centre of mass is not finite; as
/// checked_orientation(), if the orientation's norm is off 1; or if the angular velocity turns
/// about a locked axis.
template <class Real>
ModelledBody<Real> make_rigid_body(std::string_view name, const MassProperties<Real>& properties,
                                   const Pose<Same<Real>>& model_in_world = {},
                                   const Vec3<Same<Real>>& velocity = Vec3<Real>::Zero(),
                                   const Vec3<Same<Real>>& angular_velocity = Vec3<Real>::Zero(),
                                   Turning turning = Turning::free) {
  //! [from_model_to_body]
  const PrincipalAxes<Real> principal = require_possible(name, properties);
  const Vec3<Real> inverses = free_inverse_moments(name, properties.inertia, principal, turning);
  const auto [a, b, c] = closest_pair_first(inverses);
  Mat3<Real> axes;
  axes << principal.axes.col(a), principal.axes.col(b), principal.axes.col(c);
  const Pose<Real> body_in_model{properties.centre_of_mass, quaternion_of(axes)};
  const Pose<Real> pose = composed(checked_pose(model_in_world, name), body_in_model);

  ModelledBody<Real> made;
  made.model_in_body = inverse(body_in_model);
  require_finite(std::string(name) + ": centre of mass in the world", pose.position, "m");
  require_finite(std::string(name) + ": velocity", velocity, "m/s");
  made.body.centre = make_particle(properties.mass, pose.position, velocity);
  made.body.top.orientation = normalized(pose.orientation);
  made.body.top.inverse_moments = {inverses(a), inverses(b), inverses(c)};
  //! [from_model_to_body]
  set_checked_angular_velocity(name, made.body.top, angular_velocity);
  return made;
}

/// A body that no force or torque can move or turn. If it is given a velocity, it keeps it.
/// @throws std::invalid_argument if the position is not finite, or as checked_orientation().
template <class Real>
RigidBody<Real> make_static_body(std::string_view name, const Pose<Real>& pose) {
  const Pose<Real> checked = checked_pose(pose, name);
  RigidBody<Real> body;
  body.centre = make_static_particle(checked.position);
  body.top.orientation = checked.orientation;
  return body;
}

}  // namespace tumble

#ifdef TUMBLE_COMPILED_BODIES  // inside the course alone
#include <support/compiled_bodies.hpp>
#endif
