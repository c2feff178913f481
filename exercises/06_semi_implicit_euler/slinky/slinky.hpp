/// @file
/// Lab: a slinky that is hung up, and let go. It is a row of beads, the first on top, with a spring
/// between each and the next.
#pragma once

#include <exercise/todo.hpp>
#include <tumble/semi_implicit_euler.hpp>
#include <vector>

/// The force (N) of the spring between two neighbours on the upper one: `stiffness` N/m times what
/// the spring is longer than `closed` m, towards the lower one.
template <class Real>
tumble::Vec3<Real> spring_force(const tumble::Particle<Real>& upper,
                                const tumble::Particle<Real>& lower, Real stiffness, Real closed) {
  todo("the force of the stretched spring on the upper bead");
}

/// A slinky of `count` beads of `mass` kg that hangs at rest, its first bead in a hand at the
/// origin, z upward; `gravity` is 9.81 m/s² or so.
template <class Real>
std::vector<tumble::Particle<Real>> hung_up(int count, Real mass, Real stiffness, Real closed,
                                            Real gravity) {
  using namespace tumble;
  std::vector<Particle<Real>> beads;
  Real height = 0;
  for (int i = 0; i < count; ++i) {
    beads.push_back(make_particle(mass, Vec3<Real>(0, 0, height)));
    todo("let `height` go down by the spring below bead i, stretched by all that it carries");
  }
  return beads;
}

/// Belongs between kick and drift. Where the next drift would bring two neighbours closer than a
/// closed spring is long, an impulse holds them there: what the upper gets the lower loses. The
/// blow passes from pair to pair, so all are visited often.
template <class Real>
void keep_apart(std::vector<tumble::Particle<Real>>& beads, Real closed, Real time_step) {
  for (std::size_t sweep = 0; sweep < 2 * beads.size(); ++sweep)
    for (std::size_t i = 0; i + 1 < beads.size(); ++i) {
      tumble::Particle<Real>&upper = beads[i], &lower = beads[i + 1];
      const Real faster = upper.velocity.z() - lower.velocity.z();
      const Real gap = upper.position.z() - lower.position.z() + time_step * faster;
      if (gap >= closed) continue;
      const Real impulse = (closed - gap) / time_step / (upper.inverse_mass + lower.inverse_mass);
      apply_impulse(upper, tumble::Vec3<Real>(0, 0, impulse));
      apply_impulse(lower, tumble::Vec3<Real>(0, 0, -impulse));
    }
}

/// One step of `time_step` seconds of a slinky that nobody holds.
template <class Real>
void step_all(std::vector<tumble::Particle<Real>>& beads, Real stiffness, Real closed, Real gravity,
              Real time_step) {
  todo("forces of springs and gravity, kicks, keep_apart, drifts");
}

/// The slinky after `steps` steps.
template <class Real>
std::vector<tumble::Particle<Real>> dropped(std::vector<tumble::Particle<Real>> beads,
                                            Real stiffness, Real closed, Real gravity,
                                            Real time_step, int steps) {
  for (int n = 0; n < steps; ++n) step_all(beads, stiffness, closed, gravity, time_step);
  return beads;
}
