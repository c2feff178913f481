/// @file
/// The implicit rule that needs no iteration.
#pragma once

#include <tumble/turning_rules.hpp>

namespace tumble {

/// Euler's equations with the new ω and the old L: L' = L + h L × ω', ω' = I⁻¹ L'. That is linear
/// in L': (1 − h [L] I⁻¹) L' = L.
///
/// What is added to L is perpendicular to ω', so ω' · I (ω' − ω) = 0, and the energy falls by
/// ½ (ω' − ω) · I (ω' − ω): this rule can only brake. First order.
//! [turn_linearly_implicitly]
template <class Real>
void turn_linearly_implicitly(Top<Real>& top, Same<Real> time_step) {
  Vec3<Real>& L = top.angular_momentum_body;
  const Mat3<Real> change = cross_matrix(L) * top.inverse_moments.asDiagonal();
  L = solved<Real>(Mat3<Real>::Identity() - time_step * change, L);
  turn_steadily(top, time_step);
}
//! [turn_linearly_implicitly]

}  // namespace tumble
