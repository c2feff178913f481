/// @file
/// How three equal bodies have to start to chase each other along one curve.
#pragma once

#include <tumble/particle.hpp>
#include <vector>

namespace tumble::support {

/// The time in which each body runs through the whole curve, s.
inline constexpr double period_of_the_eight = 6.32591398;

/// C. Simó's starting values for the solution that A. Chenciner and R. Montgomery proved to exist
/// ("A remarkable periodic solution of the three-body problem in the case of equal masses", Annals
/// of Mathematics 152, 2000), in the plane of x and z.
template <class Real>
std::vector<Particle<Real>> three_suns() {
  const Vec3<Real> place(Real(0.97000436), 0, Real(-0.24308753));
  const Vec3<Real> velocity(Real(-0.93240737), 0, Real(-0.86473146));
  return {make_particle<Real>(1, place, -velocity / 2),
          make_particle<Real>(1, -place, -velocity / 2),
          make_particle<Real>(1, Vec3<Real>::Zero(), velocity)};
}

}  // namespace tumble::support
