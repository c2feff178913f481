// caught by: When the masses move, the angular momentum stays and the spin gives way
// message: the angular velocity was kept
#pragma once

#include <tumble/splitting.hpp>

template <class Real>
void set_booms(tumble::Top<Real>& top, const tumble::Vec3<Real>& hull, Real mass, Real reach) {
  const Real added = 2 * mass * reach * reach;
  const tumble::Vec3<Real> moments = hull + tumble::Vec3<Real>(0, added, added);
  const tumble::Vec3<Real> spin = angular_velocity_body(top);
  top.inverse_moments = moments.cwiseInverse();
  top.angular_momentum_body = moments.cwiseProduct(spin);
}

template <class Real>
bool booms_out(const tumble::Top<Real>& top, bool out) {
  const bool upside_down = top.angular_momentum_body.x() < 0;
  const bool on_its_way = tumble::gyroscopic_torque(top).x() < 0;
  return !upside_down || (out && on_its_way);
}

template <class Real>
tumble::Top<Real> flown(tumble::Top<Real> top, const tumble::Vec3<Real>& hull, Real mass,
                        Real reach, Real time_step, int steps) {
  bool out = false;
  for (int n = 0; n < steps; ++n) {
    out = booms_out(top, out);
    set_booms(top, hull, mass, out ? reach : 0);
    turn_by_splitting(top, time_step);
  }
  return top;
}
