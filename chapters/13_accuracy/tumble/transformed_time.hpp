/// @file
/// Kick and drift in a time of their own: steps that shorten where a particle is pulled hard, and
/// that are symmetric nevertheless.
#pragma once

#include <tumble/alternation.hpp>
#include <tumble/force.hpp>
#include <tumble/step_control.hpp>

namespace tumble {

/// A particle in a field of force with potential energy −U. With T for the kinetic energy and
/// B = U − T, which is constant, ln(T + B) − ln U is 0, and used as a Hamiltonian itself (the
/// logarithmic one: Mikkola and Tanikawa 1999, Preto and Tremaine 1999) it moves the
/// particle along the same path, in a time s of its own: dt = ds/(T + B) in a drift, dt = ds/U in a
/// kick. T is constant in a drift and U in a kick, so both are exact, and every row of kicks and
/// drifts may be used. Around a star half a drift, a kick and half a drift lead from a point of the
/// true ellipse to another, however long the step: by Verlet's rule, and by a row that is made of
/// its steps, only the time is wrong.
//! [transformed_time]
template <class Forces, class Real>
class TransformedTime {
 public:
  /// `evaluate_forces` returns U (J) by pull_energy(particle), besides leaving the force in the
  /// particle.
  TransformedTime(const Particle<Real>& particle, const Forces& evaluate_forces)
      : evaluate_forces_(&evaluate_forces), particle_(particle), mass_(mass_of(particle)) {
    bound_ = evaluate_forces.pull_energy(particle_) - kinetic_energy_of(particle_);
  }

  /// A step of ds (J s).
  template <class Row>
  void step(Real ds) {
    const auto drifted = [&](Real part) {
      const Real h = part / (kinetic_energy_of(particle_) + bound_);
      particle_.position += h * particle_.velocity;
      time_ += h;
    };
    const auto kicked = [&](Real part) {
      (*evaluate_forces_)(particle_, time_);
      kick(particle_, part / evaluate_forces_->pull_energy(particle_));
    };
    alternate<Row>(ds, drifted, kicked);
  }
  //! [transformed_time]

  const Particle<Real>& particle() const { return particle_; }
  Real time() const { return time_; }    ///< s since the start
  Real bound() const { return bound_; }  ///< B, J

  /// How much of s passes in a second where the particle is now, J s.
  Real rate() const { return kinetic_energy_of(particle_) + bound_; }

  /// Takes the particle to time() = `end` by a drift, a kick and a drift in time itself: for a rest
  /// that is so short that their error does not count.
  void finish(Real end) {
    const Real half = (end - time_) / 2;
    drift(particle_, half);
    (*evaluate_forces_)(particle_, time_ + half);
    kick(particle_, 2 * half);
    drift(particle_, half);
    (*evaluate_forces_)(particle_, end);
    time_ = end;
  }

 private:
  Real kinetic_energy_of(const Particle<Real>& particle) const {
    return mass_ / 2 * particle.velocity.squaredNorm();
  }

  const Forces* evaluate_forces_;
  Particle<Real> particle_;
  Real mass_, bound_ = 0, time_ = 0;
};

/// Takes a bound particle through `seconds` in about so many steps of equal length in the time s.
/// How long the last one must be is found by shortening it, which needs a few trials.
/// @throws std::invalid_argument unless the seconds are 0 or more and finite, there is at least one
/// step, and the particle is bound: B greater than 0.
template <class Row, class Forces, class Real>
void carry_in_transformed_time(Particle<Real>& particle, const Forces& evaluate_forces,
                               Same<Real> seconds, long steps) {
  require_not_negative("time", seconds, "s");
  if (steps < 1) reject("number of steps", steps, "", "it must be 1 or more");
  TransformedTime<Forces, Real> motion(particle, evaluate_forces), before = motion;
  if (!(motion.bound() > 0))
    reject("binding energy", motion.bound(), "J", "it must be greater than 0: the orbit is open");
  if (seconds == 0) return;
  const Real mean_rate = 2 * motion.bound();  // on an ellipse, by the theorem of the virial
  const Real ds = mean_rate * seconds / static_cast<Real>(steps);
  while (motion.time() < seconds) {
    before = motion;
    motion.template step<Row>(ds);
  }
  // Back to the start of the step that went too far, and again with a part of it: by the secant at
  // first, then by Newton's method.
  Real part = ds * (seconds - before.time()) / (motion.time() - before.time());
  for (int trial = 0; trial < 4; ++trial) {
    motion = before;
    motion.template step<Row>(part);
    const Real off = seconds - motion.time();
    if (std::abs(off) <= Real(1e-5) * (seconds - before.time())) break;
    part += off * motion.rate();
  }
  motion.finish(seconds);
  particle = motion.particle();
}

}  // namespace tumble
