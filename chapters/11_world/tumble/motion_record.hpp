/// @file
/// How a body moves: what a step changes of it, and so what is kept to go back to.
#pragma once

#include <tumble/rigid_body.hpp>

namespace tumble {

/// How a centre of mass moves: m and m/s, world axes.
template <class Real>
struct CentreMotion {
  Vec3<Real> position, velocity;
};

/// How a top turns: kg m²/s, body axes.
template <class Real>
struct TopMotion {
  Quaternion<Real> orientation;
  Vec3<Real> angular_momentum_body;
};

template <class Real>
CentreMotion<Real> motion_of(const Particle<Real>& centre) {
  return {centre.position, centre.velocity};
}
template <class Real>
TopMotion<Real> motion_of(const Top<Real>& top) {
  return {top.orientation, top.angular_momentum_body};
}

/// Lets it move as it did then, with nothing summed.
template <class Real>
void set_motion(Particle<Real>& centre, const CentreMotion<Real>& then) {
  centre.position = then.position;
  centre.velocity = then.velocity;
  clear_force(centre);
}
template <class Real>
void set_motion(Top<Real>& top, const TopMotion<Real>& then) {
  top.orientation = then.orientation;
  top.angular_momentum_body = then.angular_momentum_body;
  clear_torque(top);
}

}  // namespace tumble
