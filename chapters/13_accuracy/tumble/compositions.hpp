/// @file
/// Chapter 8's splitting of a free top, taken in the portions of a row.
#pragma once

#include <tumble/alternation.hpp>
#include <tumble/splitting.hpp>

namespace tumble {

/// The splitting with a sphere has three parts. The sphere's turn commutes with the others, so it
/// is made once, at the end, whatever the row. The turn about axis b is the "kick", that about c
/// the "drift". Each is exact, and carries L along; so L is kept in the world by every row.
///
/// Order: that of the row. For a symmetric top the turns about b are nothing, and any row is exact.
//! [turn_by_row]
template <class Row, class Real>
void turn_by_row(Top<Real>& top, Same<Real> time_step) {
  const Real a = top.inverse_moments[0], b = top.inverse_moments[1], c = top.inverse_moments[2];
  const Vec3<Real> before = top.angular_momentum_body;
  const Vec3<Real>& L = top.angular_momentum_body;
  alternate<Row>(
      time_step, [&](Real h) { turn_about_axis<1>(top, h * ((b - a) * L[1])); },
      [&](Real h) { turn_about_axis<2>(top, h * ((c - a) * L[2])); });
  top.angular_momentum_body = with_length_of(before, L);
  top.orientation = turn_exponential_body<Real>(top.orientation, a * L, time_step);
}
//! [turn_by_row]

}  // namespace tumble
