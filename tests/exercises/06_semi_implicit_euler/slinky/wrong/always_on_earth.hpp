// caught by: Let go, the slinky's centre falls as a stone does
// message: it falls as on Earth
#pragma once

#include <tumble/semi_implicit_euler.hpp>
#include <vector>

template <class Real>
tumble::Vec3<Real> spring_force(const tumble::Particle<Real>& upper,
                                const tumble::Particle<Real>& lower, Real stiffness, Real closed) {
  const tumble::Vec3<Real> way = lower.position - upper.position;
  const Real length = way.norm();
  return stiffness * (length - closed) / length * way;
}

template <class Real>
std::vector<tumble::Particle<Real>> hung_up(int count, Real mass, Real stiffness, Real closed,
                                            Real gravity) {
  using namespace tumble;
  std::vector<Particle<Real>> beads;
  Real height = 0;
  for (int i = 0; i < count; ++i) {
    beads.push_back(make_particle(mass, Vec3<Real>(0, 0, height)));
    const Real carried = Real(count - 1 - i) * mass * gravity;
    height -= closed + carried / stiffness;
  }
  return beads;
}

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

template <class Real>
void step_all(std::vector<tumble::Particle<Real>>& beads, Real stiffness, Real closed, Real gravity,
              Real time_step) {
  using namespace tumble;
  for (std::size_t i = 0; i < beads.size(); ++i) {
    (void)gravity;
    add_gravity(beads[i], Vec3<Real>(0, 0, Real(-9.81)));
    if (i + 1 == beads.size()) continue;
    const Vec3<Real> force = spring_force(beads[i], beads[i + 1], stiffness, closed);
    add_force(beads[i], force);
    add_force(beads[i + 1], -force);
  }
  for (Particle<Real>& bead : beads) kick(bead, time_step);
  keep_apart(beads, closed, time_step);
  for (Particle<Real>& bead : beads) {
    drift(bead, time_step);
    clear_force(bead);
  }
}

template <class Real>
std::vector<tumble::Particle<Real>> dropped(std::vector<tumble::Particle<Real>> beads,
                                            Real stiffness, Real closed, Real gravity,
                                            Real time_step, int steps) {
  for (int n = 0; n < steps; ++n) step_all(beads, stiffness, closed, gravity, time_step);
  return beads;
}
