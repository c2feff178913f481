/// @file
/// Which tensors matter can have, and the inverse of those that can be inverted.
#pragma once

#include <tumble/mass_properties.hpp>
#include <tumble/principal_axes.hpp>

namespace tumble {

/// How far an element of a tensor may be off, relative to itself, before we call the tensor wrong:
/// 32 units of roundoff, more than any formula of this chapter rounds. Give a wider slack for
/// tensors read from a file with few digits.
template <class Real>
constexpr Real element_slack = 32 * (std::numeric_limits<Real>::epsilon() / 2);

/// How far each principal moment may be off when every element is off by `slack` of itself.
///
/// A moment is λ = vᵀ I v with v its axis. So an error of slack |I_ij| in each element moves λ by
/// at most slack Σ |v_i| |I_ij| |v_j|. For a diagonal tensor that is slack λ: even a needle's
/// smallest moment is known to its last digits. For a slanted needle it is in proportion to the
/// *largest* moment: 4/3 slack of it for one along (1, 1, 1), and no more for any other.
//! [moment_slack]
template <class Real>
Vec3<Real> moment_slack(const Mat3<Real>& inertia, const Mat3<Real>& axes, Real slack) {
  Vec3<Real> sum = Vec3<Real>::Zero();
  for (int axis = 0; axis < 3; ++axis)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        sum(axis) += std::abs(axes(i, axis) * inertia(i, j) * axes(j, axis));
  return slack * sum;
}
//! [moment_slack]

/// Throws unless some arrangement of matter has this tensor (kg m²) about some point: finite,
/// symmetric, no negative moment, and no moment greater than the sum of the other two. Zero moments
/// are let pass: a rod has one, a point three. The sentence begins with `name`.
template <class Real>
PrincipalAxes<Real> require_possible_inertia(std::string_view name, const Mat3<Real>& inertia,
                                             Same<Real> slack = element_slack<Real>) {
  const PrincipalAxes<Real> principal = principal_axes(inertia, name);
  const Vec3<Real>& I = principal.moments;
  const Vec3<Real> allowed = moment_slack<Real>(inertia, principal.axes, slack);
  const std::string found =
      std::string(name) + ": the principal moments are " + text_of(I) + " kg m^2; ";
  if (I(0) < -allowed(0)) throw std::invalid_argument(found + "none can be negative");
  if (I(0) + I(1) < I(2) - allowed.sum())
    throw std::invalid_argument(
        found +
        "no real body has these: the two smaller must add up to the largest "
        "or more, but I_1 + I_2 = " +
        text_of(I(0) + I(1)) + " < I_3 = " + text_of(I(2)));
  return principal;
}

/// Throws unless the tensor (kg m²) is possible and every moment is so far from zero that it can be
/// inverted: a torque about any axis then has one answer.
template <class Real>
PrincipalAxes<Real> require_invertible_inertia(std::string_view name, const Mat3<Real>& inertia,
                                               Same<Real> slack = element_slack<Real>) {
  const PrincipalAxes<Real> principal = require_possible_inertia(name, inertia, slack);
  const Vec3<Real>& I = principal.moments;
  const std::string found =
      std::string(name) + ": the principal moments are " + text_of(I) + " kg m^2; ";
  const Vec3<Real> allowed = moment_slack<Real>(inertia, principal.axes, slack);
  if (!(I(0) > allowed(0)))
    throw std::invalid_argument(found +
                                "the first is zero as far as rounding can tell, and zero "
                                "has no inverse; give the body some thickness");
  const Real smallest = std::numeric_limits<Real>::min();
  if (I(0) < smallest || I(2) > 1 / smallest)
    throw std::invalid_argument(found + "each must lie between " + text_of(smallest) + " and " +
                                text_of(1 / smallest));
  return principal;
}

/// I⁻¹ in 1/(kg m²), in the axes of I. It is put together from the principal moments, so no
/// determinant can overflow or vanish.
/// @throws std::invalid_argument as require_invertible_inertia() does.
//! [inverse_inertia]
template <class Real>
Mat3<Real> inverse_inertia(std::string_view name, const Mat3<Real>& inertia) {
  const auto [moments, axes] = require_invertible_inertia(name, inertia);
  const Mat3<Real> inverse = moments.cwiseInverse().asDiagonal();
  return in_other_axes(inverse, axes);
}
//! [inverse_inertia]

/// The inverse of three principal moments, in 1/(kg m²): what a body stores.
/// @throws std::invalid_argument as require_invertible_inertia() does: a zero moment never turns
/// silently into an axis that nothing can turn.
template <class Real>
Vec3<Real> inverse_moments(std::string_view name, const Vec3<Real>& moments) {
  const Mat3<Real> diagonal = moments.asDiagonal();
  require_invertible_inertia(name, diagonal);
  return moments.cwiseInverse();
}

/// Throws unless the mass is positive, the centre finite and the tensor possible.
template <class Real>
void require_possible(std::string_view name, const MassProperties<Real>& body) {
  require_mass(std::string(name) + ": mass", body.mass);
  require_finite(std::string(name) + ": centre of mass", body.centre_of_mass, "m");
  require_possible_inertia(name, body.inertia);
}

}  // namespace tumble
