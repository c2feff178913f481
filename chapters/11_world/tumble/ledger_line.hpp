/// @file
/// A line of the books of a world: what somebody put in or took out, and what bodies have.
#pragma once

#include <tumble/step_plan.hpp>

namespace tumble {

/// A line of the books: an amount of energy (J), momentum (kg m/s) and angular momentum about the
/// world's origin (kg m²/s), world axes.
struct LedgerLine {
  std::string name;                        ///< whose it is
  double energy = 0;                       ///< J
  Vec3d momentum = Vec3d::Zero();          ///< kg m/s, world axes
  Vec3d angular_momentum = Vec3d::Zero();  ///< about the origin, kg m²/s, world axes

  LedgerLine& operator+=(const LedgerLine& other) {
    energy += other.energy;
    momentum += other.momentum;
    angular_momentum += other.angular_momentum;
    return *this;
  }
  LedgerLine& operator-=(const LedgerLine& other) {
    energy -= other.energy;
    momentum -= other.momentum;
    angular_momentum -= other.angular_momentum;
    return *this;
  }
};

/// The kinetic energy and the momenta of one body.
template <class Real>
LedgerLine holdings_of(const BodyState<Real>& body) {
  const Particle<double> centre{.position = body.centre.position.template cast<double>(),
                                .velocity = body.centre.velocity.template cast<double>(),
                                .inverse_mass = static_cast<double>(body.centre.inverse_mass)};
  const Vec3d angular_velocity = angular_velocity_body(body.top).template cast<double>();
  const Vec3d angular_momentum = body.top.angular_momentum_body.template cast<double>();
  const Quaternion<double> q{static_cast<double>(body.top.orientation.real),
                             body.top.orientation.imaginary.template cast<double>()};
  const Vec3d p = momentum(centre);
  return {{},
          kinetic_energy(centre) + dot(angular_velocity, angular_momentum) / 2,
          p,
          centre.position.cross(p) + rotate(q, angular_momentum)};
}

/// The same of all bodies together.
template <class Real>
LedgerLine holdings_of(const Bodies<Real>& bodies) {
  LedgerLine sum;
  for (BodyIndex body = 0; body < bodies.centres.size(); ++body)
    sum += holdings_of(state_of(bodies, body));
  return sum;
}

/// What a push gives a body in the kick of `time_step` seconds, exact but for rounding. `before`
/// and `after` are the body around the kick, when it has not yet moved.
///
/// With Δv = h ΣF/m the energy grows by ½ m (v' + v)·(v' − v) = h ΣF · ½ (v + v'). The sum splits
/// into the effects' shares, and the same holds for L, with ½ (ω + ω').
template <class Real>
LedgerLine work_of(const Push<Real>& push, const BodyState<Real>& before,
                   const BodyState<Real>& after, Real time_step) {
  const double h = static_cast<double>(time_step);
  LedgerLine work;
  if (!is_static(before.centre)) {
    const Vec3d mean = (before.centre.velocity.template cast<double>() +
                        after.centre.velocity.template cast<double>()) /
                       2;
    work.momentum = h * push.force.template cast<double>();
    work.energy = dot(work.momentum, mean);
    work.angular_momentum = before.centre.position.template cast<double>().cross(work.momentum);
  }
  const Vec3<Real> torque_body =
      free_part<Real>(before.top, rotate_back(before.top.orientation, push.torque));
  const Vec3d mean_spin = (angular_velocity_body(before.top).template cast<double>() +
                           angular_velocity_body(after.top).template cast<double>()) /
                          2;
  work.energy += h * dot(torque_body.template cast<double>(), mean_spin);
  work.angular_momentum +=
      h * rotate<Real>(before.top.orientation, torque_body).template cast<double>();
  return work;
}

}  // namespace tumble
