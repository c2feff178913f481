/// @file
/// Lab: the forces that one feels on a merry-go-round, as an effect.
#pragma once

#include <exercise/todo.hpp>
#include <string_view>
#include <tumble/effect.hpp>

/// What a merry-go-round does to whoever looks at the world from it: places and velocities are
/// those seen on board, from its centre and in axes that turn with it.
template <class Real>
struct MerryGoRound {
  static constexpr std::string_view name = "merry-go-round";
  tumble::Vec3<Real> spin = tumble::Vec3<Real>::Zero();  ///< Ω of the merry-go-round, rad/s

  /// Why no body needs it, or nothing if some do.
  std::string_view skip_reason(const tumble::BodyFlags& flags) const {
    //! [solution] the predicate: when is there nothing to do?
    return spin == tumble::Vec3<Real>::Zero() ? "it stands still" : "";
    //! [end]
  }

  /// The force (N) on a body, of both kinds: outward, and sideways to its motion.
  tumble::Vec3<Real> force(const tumble::Particle<Real>& body, Real time) const {
    //! [solution] the centrifugal force and Coriolis's
    const tumble::Vec3<Real> carried = spin.cross(body.position);
    return -mass_of(body) * (2 * spin.cross(body.velocity) + spin.cross(carried));
    //! [end]
  }

  /// The energy (J) on which the outward force draws when a body goes outward.
  Real potential_energy(const tumble::BodyState<Real>& body) const {
    //! [solution] the potential energy of the centrifugal force
    const tumble::Vec3<Real> carried = spin.cross(body.centre.position);
    return -mass_of(body.centre) * carried.squaredNorm() / 2;
    //! [end]
  }
};

static_assert(tumble::ForceOnCentre<MerryGoRound<double>, double>, "a world could not use this");

/// The three of them as functions. `is_skipped` is 1 if the plan would leave the effect out, else
/// 0.
template <class Real>
tumble::Vec3<Real> force_on(const tumble::Particle<Real>& body, const tumble::Vec3<Real>& spin) {
  return MerryGoRound<Real>{spin}.force(body, Real(0));
}

template <class Real>
Real potential_energy_of(const tumble::Particle<Real>& body, const tumble::Vec3<Real>& spin) {
  return MerryGoRound<Real>{spin}.potential_energy({body, tumble::Top<Real>{}});
}

template <class Real>
int is_skipped(const tumble::Vec3<Real>& spin) {
  return tumble::skip_reason<Real>(MerryGoRound<Real>{spin}, tumble::BodyFlags{}).empty() ? 0 : 1;
}
