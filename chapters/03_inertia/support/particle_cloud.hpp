/// @file
/// Bodies made of particles: strewn at random or set up in rows.
#pragma once

#include <support/random_generator.hpp>
#include <tumble/mass_properties.hpp>

namespace tumble::support {

/// `count` equal particles anywhere in a box about the origin, 1 kg in all.
template <class Real>
std::vector<Particle<Real>> random_particles(const Vec3<Real>& size, int count, unsigned seed) {
  RandomGenerator dice(seed);
  std::vector<Particle<Real>> particles(static_cast<std::size_t>(count));
  for (Particle<Real>& particle : particles)
    particle = {.position = size.cwiseProduct(dice.vector<Real>()) / 2,
                .inverse_mass = Real(count)};
  return particles;
}

/// n × n × n equal particles in the middles of as many equal cells of a box about the origin, 1 kg
/// in all.
template <class Real>
std::vector<Particle<Real>> lattice_particles(const Vec3<Real>& size, int n) {
  std::vector<Particle<Real>> particles;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k) {
        const Vec3<Real> cell =
            (Vec3<Real>(Real(i), Real(j), Real(k)).array() + Real(0.5)).matrix() / Real(n);
        particles.push_back({.position = size.cwiseProduct(cell - Vec3<Real>::Constant(Real(0.5))),
                             .inverse_mass = Real(n * n * n)});
      }
  return particles;
}

/// How far a tensor is from the true one, relative to it: the root of the summed squares of all
/// nine differences.
template <class Real>
Real relative_error(const Mat3<Real>& inertia, const Mat3<Same<Real>>& truth) {
  return (inertia - truth).norm() / truth.norm();
}

/// Any turn, from four random numbers.
template <class Real>
Mat3<Real> random_turn(RandomGenerator& dice) {
  const Vec3<Real> v = dice.vector<Real>();
  return Eigen::Quaternion<Real>(Real(dice.both_ways()), v.x(), v.y(), v.z())
      .normalized()
      .toRotationMatrix();
}

}  // namespace tumble::support
