// caught by: Ordered upside down, it turns over and stays so
// message: Leave flown as it was
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
  const bool on_its_way = tumble::gyroscopic_torque(top).x() < 0;
  return !upside_down || (out && on_its_way);
}

template <class Real>
tumble::Top<Real> flown(tumble::Top<Real> top, const tumble::Vec3<Real>&, Real, Real, Real, int) {
  top.angular_momentum_body = {-top.angular_momentum_body.norm(), 0, 0};
  return top;
}
