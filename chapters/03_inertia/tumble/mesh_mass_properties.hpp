/// @file
/// The mass properties of whatever a closed mesh encloses, by the divergence theorem.
#pragma once

#include <tumble/compensated_sum.hpp>
#include <tumble/mass_properties.hpp>
#include <tumble/mesh.hpp>

namespace tumble {

/// A mesh seen from its own middle, in a unit of its own size, so that no sum sees how far away the
/// model's origin is and no power of a length leaves the range of `Real`. The unit is a power of
/// two: dividing by it rounds nothing.
template <class Real>
struct MeshFrame {
  Vec3<Real> middle;  ///< of the smallest box around the triangles, m
  int exponent;       ///< the unit is 2^exponent m, longer than half of any edge of that box

  explicit MeshFrame(const Mesh<Real>& mesh) {
    Vec3<Real> low = mesh.vertices[mesh.triangles[0][0]], high = low;
    for (const auto& triangle : mesh.triangles)
      for (const std::size_t corner : triangle) {
        low = low.cwiseMin(mesh.vertices[corner]);
        high = high.cwiseMax(mesh.vertices[corner]);
      }
    const Vec3<Real> half = (high - low) / 2;
    middle = low + half;
    exponent = std::ilogb(half.maxCoeff()) + 1;
  }

  /// A `point` (m, model axes) from the middle, in the units.
  Vec3<Real> from_model(const Vec3<Real>& point) const {
    return (point - middle) * std::ldexp(Real(1), -exponent);
  }
};

/// Integrals over the inside of a mesh, in the units of a MeshFrame.
template <class Real>
struct MeshIntegrals {
  Real volume;                ///< ∫ dV
  Vec3<Real> first_moment;    ///< ∫ r dV
  Mat3<Real> second_moments;  ///< ∫ r rᵀ dV
  Real rounding;              ///< how far the roundings of all D may put the volume off
};

/// The cross product with + in place of −. Of D = a·(b × c) a computer knows no more than: it is
/// off by at most 8 roundings of what this gives for |a|, |b| and |c|, 3 from the corners
/// themselves and 5 from the products and sums.
template <class Real>
Vec3<Real> sum_of_products(const Vec3<Real>& b, const Vec3<Real>& c) {
  return {b.y() * c.z() + b.z() * c.y(), b.z() * c.x() + b.x() * c.z(),
          b.x() * c.y() + b.y() * c.x()};
}

/// Integrates over the inside of the mesh by walking over its skin, with r counted from `origin`.
///
/// If f is homogeneous of degree k, f(sr) = s^k f(r), then div(r f) = (3 + k) f. So by the
/// divergence theorem ∫ f dV = 1/(3 + k) ∮ f (r·n) dA. Over a flat triangle with corners a, b, c
/// the factor r·n dA is a constant, and the integral comes to the one over the tetrahedron from the
/// origin:
///   ∫ dV = Σ D/6,   ∫ r dV = Σ D/24 s,   ∫ r rᵀ dV = Σ D/120 (a aᵀ + b bᵀ + c cᵀ + s sᵀ),
/// D = a·(b × c), s = a + b + c. A triangle that faces the origin has D < 0 and takes its
/// tetrahedron away again.
//! [integrate]
template <class Real>
MeshIntegrals<Real> integrate(const Mesh<Real>& mesh, const MeshFrame<Real>& frame,
                              const Vec3<Real>& origin) {
  CompensatedSum<Real> volume(0);
  CompensatedSum<Vec3<Real>> first(Vec3<Real>::Zero());
  CompensatedSum<Mat3<Real>> second(Mat3<Real>::Zero());
  Real rounding = 0;
  for (const auto& [i, j, k] : mesh.triangles) {
    const Vec3<Real> a = frame.from_model(mesh.vertices[i]) - origin;
    const Vec3<Real> b = frame.from_model(mesh.vertices[j]) - origin;
    const Vec3<Real> c = frame.from_model(mesh.vertices[k]) - origin;
    const Vec3<Real> s = a + b + c;
    const Real D = dot(a, b.cross(c));
    const Mat3<Real> squares =
        a * a.transpose() + b * b.transpose() + c * c.transpose() + s * s.transpose();
    volume.add(D / 6);
    first.add(D / 24 * s);
    second.add(D / 120 * squares);
    rounding += 8 / Real(6) * (std::numeric_limits<Real>::epsilon() / 2) *
                dot(a.cwiseAbs(), sum_of_products<Real>(b.cwiseAbs(), c.cwiseAbs()));
  }
  return {volume.sum, first.sum, second.sum, rounding};
}
//! [integrate]

/// Integrates seen from the middle of the mesh.
/// @throws std::invalid_argument if the mesh is not closed, is inside out or encloses nothing.
template <class Real>
MeshIntegrals<Real> checked_integrals(const Mesh<Real>& mesh, const MeshFrame<Real>& frame) {
  const MeshIntegrals<Real> integrals = integrate<Real>(mesh, frame, Vec3<Real>::Zero());
  if (std::abs(integrals.volume) <= integrals.rounding)
    throw std::invalid_argument(
        "the mesh encloses no volume: its two sides lie on each other, as far as rounding can "
        "tell");
  if (integrals.volume < 0)
    throw std::invalid_argument("the mesh is inside out: its volume is " +
                                text_of(std::ldexp(integrals.volume, 3 * frame.exponent)) +
                                " m^3; turn the triangles round by swapping two corners of each");
  return integrals;
}

/// The volume inside a closed mesh, m³.
/// @throws std::invalid_argument if the mesh is not closed, is inside out or encloses nothing.
template <class Real>
Real volume(const Mesh<Real>& mesh) {
  require_closed(mesh);
  const MeshFrame<Real> frame(mesh);
  return std::ldexp(checked_integrals(mesh, frame).volume, 3 * frame.exponent);
}

/// The mass properties of `mass` kg spread evenly through a closed mesh.
///
/// The mesh is walked over twice: for the centre of mass, then for the second moments about it. So
/// nothing large is subtracted from anything large at the end. The first walk starts from the
/// middle of the box, which may lie outside even a convex body; the second starts from the centre
/// of mass, which lies within, so there all the tetrahedra of a convex body are positive. The
/// compensated sums keep the error to a few dozen units of roundoff of Σ|D| |squares|, however many
/// triangles there are.
/// @throws std::invalid_argument as volume() does, or if the mass is not positive.
template <class Real>
MassProperties<Real> mass_properties(const Mesh<Real>& mesh, Same<Real> mass) {
  require_mass("mass", mass);
  require_closed(mesh);
  const MeshFrame<Real> frame(mesh);
  const MeshIntegrals<Real> about_middle = checked_integrals(mesh, frame);
  const Vec3<Real> centre = about_middle.first_moment / about_middle.volume;
  const MeshIntegrals<Real> about_centre = integrate(mesh, frame, centre);
  const Mat3<Real> S = about_centre.second_moments / about_centre.volume;
  const Real unit = std::ldexp(Real(1), frame.exponent);
  return {mass, frame.middle + unit * centre, mass * unit * unit * inertia_from_second_moments(S)};
}

}  // namespace tumble
