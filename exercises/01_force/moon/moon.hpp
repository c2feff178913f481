/// @file
/// Exercise: throw a ball on the Moon.
#pragma once

#include <exercise/todo.hpp>
#include <tumble/force.hpp>

/// The acceleration of everything that falls near the ground, m/s², z upward.
template <class Real>
tumble::Vec3<Real> gravity() {
  return {0, 0, Real(-9.81)};
}

/// How high (m) a ball rises that is thrown straight up with `speed` m/s, in steps of `time_step`
/// seconds. A ball that gets a kilometre high counts as lost.
template <class Real>
Real highest_point(Real speed, Real time_step) {
  using namespace tumble;
  Particle<Real> ball = make_particle(Real(1), Vec3<Real>::Zero(), Vec3<Real>(0, 0, speed));
  Real highest = 0;
  while (ball.velocity.z() > 0 && ball.position.z() < 1000) {
    accelerate(ball, gravity<Real>(), time_step);
    step(ball, time_step);
    highest = std::max(highest, ball.position.z());
  }
  return highest;
}
