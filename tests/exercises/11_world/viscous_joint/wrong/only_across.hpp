// caught by: The joint takes away c times the square of the sliding speed, and never gives
// message: only what goes across the line between the centres is braked
#pragma once

#include <string_view>
#include <tumble/effect.hpp>
#include <vector>

template <class Real>
struct ViscousJoint {
  static constexpr std::string_view name = "viscous joint";
  Real coefficient = 0;  ///< c, N s/m

  tumble::PairPush<Real> push(const tumble::BodyState<Real>& first,
                              const tumble::BodyState<Real>& second, Real) const {
    const tumble::Vec3<Real> arm = (second.centre.position - first.centre.position) / 2;
    const tumble::Vec3<Real> other_arm = -arm;
    const tumble::Vec3<Real> sliding =
        (first.centre.velocity + angular_velocity_world(first.top).cross(arm)) -
        (second.centre.velocity + angular_velocity_world(second.top).cross(other_arm));
    const tumble::Vec3<Real> n = arm.normalized();
    const tumble::Vec3<Real> force = -coefficient * (sliding - n.dot(sliding) * n);
    return {.force_on_first = force,
            .torque_on_first = arm.cross(force),
            .torque_on_second = -other_arm.cross(force)};
  }
};

static_assert(tumble::PushBetween<ViscousJoint<double>, double>, "a world could not use this");

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
