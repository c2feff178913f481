// caught by: What rests on the ground is seen to go round in a circle, and this force holds it on
// that circle message: Does the force see the velocity?
#pragma once

#include <string_view>
#include <tumble/effect.hpp>

template <class Real>
struct MerryGoRound {
  static constexpr std::string_view name = "merry-go-round";
  tumble::Vec3<Real> spin = tumble::Vec3<Real>::Zero();

  std::string_view why_skipped(const tumble::Facts& facts) const {
    return spin == tumble::Vec3<Real>::Zero() ? "it stands still" : "";
  }

  tumble::Vec3<Real> force(const tumble::Particle<Real>& body, Real time) const {
    const tumble::Vec3<Real> carried = spin.cross(body.position);
    return -mass_of(body) * (0 * spin.cross(body.velocity) + spin.cross(carried));
  }

  Real potential_energy(const tumble::BodyState<Real>& body) const {
    const tumble::Vec3<Real> carried = spin.cross(body.centre.position);
    return -mass_of(body.centre) * carried.squaredNorm() / 2;
  }
};

static_assert(tumble::ForceOnCentre<MerryGoRound<double>, double>, "a world could not use this");

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
  return tumble::why_skipped<Real>(MerryGoRound<Real>{spin}, tumble::Facts{}).empty() ? 0 : 1;
}
