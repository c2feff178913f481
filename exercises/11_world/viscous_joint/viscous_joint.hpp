/// @file
/// Exercise: an effect of your own between two bodies, which brakes what they do against each other
/// and nothing else.
#pragma once

#include <exercise/todo.hpp>
#include <string_view>
#include <tumble/effect.hpp>
#include <vector>

/// Thick grease between two bodies, half-way between their centres of mass. It resists all of the
/// velocity that the one has against the other there, whichever way it points.
template <class Real>
struct ViscousJoint {
  static constexpr std::string_view name = "viscous joint";
  Real coefficient = 0;  ///< c, N s/m

  /// What it does to both, in world axes. The force on the second is the opposite of the one on the
  /// first; each torque is about the centre of mass of its own body.
  tumble::PairPush<Real> push(const tumble::BodyState<Real>& first,
                              const tumble::BodyState<Real>& second, Real) const {
    todo("the force between the points that rub at each other, and its torques");
  }
};

static_assert(tumble::PushBetween<ViscousJoint<double>, double>, "a world could not use this");

/// The effect on two bodies, given place, velocity and spin (rad/s, world axes) of
/// each: the force on the first, the torque on it, the torque on the second.
template <class Real>
std::vector<tumble::Vec3<Real>> pushed(Real coefficient, const tumble::Vec3<Real>& place,
                                       const tumble::Vec3<Real>& velocity,
                                       const tumble::Vec3<Real>& spin,
                                       const tumble::Vec3<Real>& other_place,
                                       const tumble::Vec3<Real>& other_velocity,
                                       const tumble::Vec3<Real>& other_spin) {
  using tumble::Vec3;
  const auto body_centre = tumble::make_particle<Real>(1, place, velocity);
  const auto other_centre = tumble::make_particle<Real>(1, other_place, other_velocity);
  tumble::Top<Real> top, other_top;
  top.inverse_moments = Vec3<Real>(1, Real(0.5), Real(0.25));
  top.orientation = tumble::quaternion_of_rotation_vector<Real>(Vec3<Real>(1, 0, Real(0.5)));
  other_top.inverse_moments = Vec3<Real>(Real(0.5), Real(0.25), 1);
  tumble::set_angular_velocity_world<Real>(top, spin);
  tumble::set_angular_velocity_world<Real>(other_top, other_spin);
  const auto push =
      ViscousJoint<Real>{coefficient}.push({body_centre, top}, {other_centre, other_top}, Real(0));
  return {push.force_on_first, push.torque_on_first, push.torque_on_second};
}
