/// @file
/// What resists a turn: the inertia tensor, particle by particle.
#pragma once

#include <algorithm>
#include <limits>
#include <tumble/require.hpp>

namespace tumble {

/// The inertia tensor (kg m²) that belongs to the second moments of mass S = Σ m r rᵀ (kg m²) about
/// the same point in the same axes: I_ij = δ_ij (S_xx + S_yy + S_zz) − S_ij.
///
/// On the diagonal S_xx + S_yy + S_zz − S_xx is written as S_yy + S_zz: nothing cancels, so a
/// needle keeps every digit of its small moment. Off the diagonal the sign is −: I_xy = −Σ m x y,
/// called a product of inertia. Some tools print +Σ m x y under the same name; ask which.
//! [inertia_from_second_moments]
template <class Real>
Mat3<Real> inertia_from_second_moments(const Mat3<Real>& S) {
  Mat3<Real> inertia = -S;
  inertia.diagonal() << S(1, 1) + S(2, 2), S(0, 0) + S(2, 2), S(0, 0) + S(1, 1);
  return inertia;
}
//! [inertia_from_second_moments]

/// What one particle of `mass` kg contributes to the tensor about a point, r metres away from that
/// point: m (r² δ − r rᵀ), kg m², in the axes in which r is given.
//! [inertia_of_particle]
template <class Real>
Mat3<Real> inertia_of_particle(Real mass, const Vec3<Same<Real>>& r) {
  const Mat3<Real> r_r = r * r.transpose();
  return mass * inertia_from_second_moments(r_r);
}
//! [inertia_of_particle]

/// The energy of turning, ½ ωᵀ I ω, in J; tensor (kg m²) and angular velocity ω (rad/s) in the same
/// axes, whichever they are.
template <class Real>
Real turning_energy(const Mat3<Real>& inertia, const Vec3<Same<Real>>& angular_velocity) {
  return dot(angular_velocity, inertia * angular_velocity) / 2;
}

/// Throws unless the tensor called `name` is finite and equal to its transpose.
///
/// A tensor that was turned by matrix products differs from its transpose by rounding: every
/// element of R I Rᵀ sums nine products with six roundings each, at most 3 · 6 units of roundoff of
/// the largest element, and the mirrored element as much again: 36. The largest element may have
/// been half as large again before the turn, but no larger, because the trace stays, and is at
/// least twice the largest moment. So 64 units are let pass.
template <class Real>
void require_symmetric(std::string_view name, const Mat3<Real>& inertia) {
  if (!is_finite(inertia))
    throw std::invalid_argument(std::string(name) +
                                ": an element of the inertia tensor is infinite or NaN; "
                                "every element must be finite");
  Real largest = 0;
  for (int i = 0; i < 9; ++i) largest = std::max(largest, std::abs(inertia(i)));
  const Real slack = 64 * (std::numeric_limits<Real>::epsilon() / 2) * largest;
  const char* const axis = "xyz";
  for (int i = 0; i < 3; ++i)
    for (int j = i + 1; j < 3; ++j)
      if (std::abs(inertia(i, j) - inertia(j, i)) > slack)
        throw std::invalid_argument(std::string(name) + ": I_" + axis[i] + axis[j] + " is " +
                                    text_of(inertia(i, j)) + " and I_" + axis[j] + axis[i] +
                                    " is " + text_of(inertia(j, i)) +
                                    " kg m^2; an inertia tensor is symmetric: they must be equal");
}

}  // namespace tumble
