/// @file
/// All that a rigid body's shape means to its motion: ten numbers, and how they move and add.
#pragma once

#include <tumble/compensated_sum.hpp>
#include <tumble/inertia.hpp>
#include <tumble/orthonormal.hpp>
#include <tumble/particle.hpp>
#include <vector>

namespace tumble {

/// The mass of a body and how it is spread. Positions and axes are those of the model: whatever
/// origin and axes its sizes, corners or particles were given in.
//! [mass_properties]
template <class Real>
struct MassProperties {
  Real mass = 0;                                   ///< kg
  Vec3<Real> centre_of_mass = Vec3<Real>::Zero();  ///< m, from the model's origin
  Mat3<Real> inertia = Mat3<Real>::Zero();         ///< kg m², about the centre of mass
};
//! [mass_properties]

using MassPropertiesf = MassProperties<float>;
using MassPropertiesd = MassProperties<double>;

/// The tensor about `point` (m, from the model's origin), in the model's axes: the parallel axis
/// theorem, I = I_c + M (d² δ − d dᵀ), where d leads from the centre of mass to the point.
//! [inertia_about]
template <class Real>
Mat3<Real> inertia_about(const MassProperties<Real>& body, const Vec3<Same<Real>>& point) {
  const Vec3<Real> d = point - body.centre_of_mass;
  return body.inertia + inertia_of_particle(body.mass, d);
}
//! [inertia_about]

/// The way back, I_c = I − M (d² δ − d dᵀ): mass properties from a tensor (kg m²) about `point`
/// (m), as tables and files often give it. The difference of two large numbers loses digits when
/// the point is far away; no later care brings them back.
template <class Real>
MassProperties<Real> from_inertia_about(const Vec3<Real>& point, const Mat3<Same<Real>>& inertia,
                                        Same<Real> mass, const Vec3<Same<Real>>& centre_of_mass) {
  const Vec3<Real> d = point - centre_of_mass;
  const Mat3<Real> shift = inertia_of_particle(mass, d);
  return {mass, centre_of_mass, inertia - shift};
}

/// The same tensor in other axes, R I Rᵀ; the columns of the turn R are the old axes, seen from
/// the new ones. The result is symmetric to the bit.
//! [in_other_axes]
template <class Real>
Mat3<Real> in_other_axes(const Mat3<Real>& inertia, const Mat3<Same<Real>>& R) {
  const Mat3<Real> turned = R * inertia * R.transpose();
  return (turned + turned.transpose()) / 2;
}
//! [in_other_axes]

/// Throws unless `matrix` turns a body and does nothing else to it: columns of length 1,
/// perpendicular to each other, right-handed. 1024 units of roundoff are let pass, so that a
/// product of fifty turns is still one. A turn's own columns and each multiplication may be off by
/// some ten units, which add up if all the turns are the same; of different turns a thousand will
/// do.
template <class Real>
void require_turn(std::string_view name, const Mat3<Real>& matrix) {
  if (!is_finite(matrix))
    throw std::invalid_argument(std::string(name) +
                                " does not turn rigidly; an element of it is infinite or NaN");
  const Real error = orthonormality_error(matrix);
  const Real slack = 1024 * (std::numeric_limits<Real>::epsilon() / 2);
  if (!(error <= slack))
    throw std::invalid_argument(std::string(name) +
                                " does not turn rigidly; its columns must have length 1 and be "
                                "perpendicular to each other, and one product is off by " +
                                text_of(error));
  if (triple_product(matrix) < 0)
    throw std::invalid_argument(std::string(name) + " mirrors; its columns must be right-handed");
}

/// The same body after turning it by the turn R about the model's origin and then shifting it
/// by `shift` metres.
/// @throws std::invalid_argument if R does more than turn or the shift is not finite.
template <class Real>
MassProperties<Real> moved(const MassProperties<Real>& body, const Mat3<Same<Real>>& R,
                           const Vec3<Same<Real>>& shift) {
  require_turn("the matrix that moves a body", R);
  require_finite("the shift that moves a body", shift, "m");
  return {body.mass, R * body.centre_of_mass + shift, in_other_axes(body.inertia, R)};
}

/// One rigid body made of several, given in the same model axes.
///
/// Every position is taken from a point inside the body before it is squared: first from the centre
/// of the first part, to find the common centre, then from that. So the digits that tell the parts
/// from each other survive even when the model's origin is far away.
/// @throws std::invalid_argument if there is no part or a part's mass is not positive.
//! [combined]
template <class Real>
MassProperties<Real> combined(const std::vector<MassProperties<Real>>& parts) {
  if (parts.empty()) throw std::invalid_argument("a compound body needs at least one part");
  const Vec3<Real> inside = parts.front().centre_of_mass;
  MassProperties<Real> whole;
  Vec3<Real> first_moment = Vec3<Real>::Zero();
  for (const MassProperties<Real>& part : parts) {
    require_mass("the mass of a part", part.mass);
    whole.mass += part.mass;
    first_moment += part.mass * (part.centre_of_mass - inside);
  }
  whole.centre_of_mass = inside + first_moment / whole.mass;
  for (const MassProperties<Real>& part : parts)
    whole.inertia += inertia_about(part, whole.centre_of_mass);
  return whole;
}
//! [combined]

/// The mass properties of particles at fixed mutual distances: their mean position, weighted by
/// mass, and the sum of their tensors about it.
/// @throws std::invalid_argument if there is none or one of them is static: it has no mass to
/// share.
template <class Real>
MassProperties<Real> mass_properties(const std::vector<Particle<Real>>& particles) {
  if (particles.empty()) throw std::invalid_argument("a body needs at least one particle");
  const Vec3<Real> inside = particles.front().position;
  CompensatedSum<Real> mass(0);
  CompensatedSum<Vec3<Real>> first_moment(Vec3<Real>::Zero());
  for (const Particle<Real>& particle : particles) {
    require_mass("the mass of a particle", mass_of(particle));
    mass.add(mass_of(particle));
    first_moment.add(mass_of(particle) * (particle.position - inside));
  }
  const Vec3<Real> centre = inside + first_moment.sum / mass.sum;
  CompensatedSum<Mat3<Real>> inertia(Mat3<Real>::Zero());
  for (const Particle<Real>& particle : particles)
    inertia.add(inertia_of_particle(mass_of(particle), particle.position - centre));
  return {mass.sum, centre, inertia.sum};
}

}  // namespace tumble
