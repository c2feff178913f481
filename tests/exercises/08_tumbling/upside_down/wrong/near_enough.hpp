// caught by: The booms stay out until the satellite is as far upside down as it gets
// message: L_x still falls: the booms come in before
#pragma once

#include <tumble/splitting.hpp>

template <class Real>
void set_booms(tumble::Top<Real>& top, const tumble::Vec3<Real>& hull, Real mass, Real reach) {
  const Real added = 2 * mass * reach * reach;
  const tumble::Vec3<Real> moments = hull + tumble::Vec3<Real>(0, added, added);
  top.inverse_moments = moments.cwiseInverse();
}

template <class Real>
bool booms_out(const tumble::Top<Real>& top, bool out) {
  const bool upside_down = top.angular_momentum_body.x() < 0;
  const bool on_its_way =
      top.angular_momentum_body.x() > Real(-0.999) * top.angular_momentum_body.norm();
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
