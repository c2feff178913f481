/// @file
/// A free top cut into motions that each have an exact solution.
#pragma once

#include <array>
#include <tumble/euler_equations.hpp>
#include <tumble/sine_cosine.hpp>

namespace tumble {

/// Multiplies the orientation by the quaternion c + s axis, about body axis 0, 1 or 2, and turns L
/// back by as much: it stands still in the world.
///
/// With the half angle's c and s, sin a is 2 s c and 1 − cos a is 2 s². So the new L_x, which is
/// L_x + sin a L_y − (1 − cos a) L_x, is L_x + 2 s (c L_y − s L_x). That keeps its digits where the
/// angle is small. `twice` is 2 s/(c² + s²), so the quaternion need not be unit.
//! [turn_by_half]
template <int axis, class Real>
void turn_by_half(Top<Real>& top, Same<Real> c, Same<Real> s, Same<Real> twice) {
  constexpr int next = (axis + 1) % 3, last = (axis + 2) % 3;
  Vec3<Real>& L = top.angular_momentum_body;
  const Real L_next = L[next], L_last = L[last];
  L[next] = L_next + twice * (c * L_last - s * L_next);
  L[last] = L_last - twice * (c * L_next + s * L_last);

  const Quaternion<Real> q = top.orientation;  // times the quaternion c + s axis
  top.orientation.real = c * q.real - s * q.imaginary[axis];
  top.orientation.imaginary[axis] = c * q.imaginary[axis] + s * q.real;
  top.orientation.imaginary[next] = c * q.imaginary[next] + s * q.imaginary[last];
  top.orientation.imaginary[last] = c * q.imaginary[last] - s * q.imaginary[next];
}
//! [turn_by_half]

/// Turns the top by `angle` (rad) about its body axis 0, 1 or 2, with L standing still in the
/// world.
//! [turn_about_axis]
template <int axis, class Real>
void turn_about_axis(Top<Real>& top, Same<Real> angle) {
  const auto [s, c] = sine_cosine(Real(angle / 2));
  turn_by_half<axis, Real>(top, c, s, 2 * s);
}
//! [turn_about_axis]

/// `vector`, which a turn has made from `before`, with the length that it had. The length has only
/// been rounded, so a correction to first order will do: v (b² − v²)/(2 v²). It is a small number
/// to add; to multiply by a number next to 1 would round the same way every time.
///
/// A large correction means squares that have left the range of Real, or 0/0, and is left undone.
//! [with_length_of]
template <class Real>
Vec3<Real> with_length_of(const Vec3<Real>& before, const Vec3<Real>& vector) {
  using std::abs;
  const Real square = vector.squaredNorm();
  const Real correction = (before.squaredNorm() - square) / (2 * square);
  const Real largest = 256 * std::numeric_limits<Real>::epsilon();
  return vector + select(abs(correction) <= largest, correction, Real(0)) * vector;
}
//! [with_length_of]

/// The energy ½ Σ L_k²/I_k as three, one for each axis. A top with the energy of one of them spins
/// about that axis by h L_k/I_k. Half the first two, all of the third, and back: second order.
//! [turn_axis_by_axis]
template <class Real>
void turn_axis_by_axis(Top<Real>& top, Same<Real> time_step) {
  const Vec3<Real>& i = top.inverse_moments;
  const Vec3<Real> before = top.angular_momentum_body;
  const Vec3<Real>& L = top.angular_momentum_body;
  turn_about_axis<0>(top, time_step / 2 * (i[0] * L[0]));
  turn_about_axis<1>(top, time_step / 2 * (i[1] * L[1]));
  turn_about_axis<2>(top, time_step * (i[2] * L[2]));
  turn_about_axis<1>(top, time_step / 2 * (i[1] * L[1]));
  turn_about_axis<0>(top, time_step / 2 * (i[0] * L[0]));
  top.angular_momentum_body = with_length_of(before, top.angular_momentum_body);
  top.orientation = renormalized(top.orientation);
}
//! [turn_axis_by_axis]

/// The energy as that of a sphere with moment I_a, and what is left of axes c and b:
/// |L|²/2I_a + ½ L_c² (1/I_c − 1/I_a) + ½ L_b² (1/I_b − 1/I_a).
///
/// The sphere turns about L, which the others carry along, so its turn can be made at the end. With
/// 1/I_a and 1/I_b the closest pair, the last part is the smallest that it can be; for a symmetric
/// top it is nothing, and the step is exact.
//! [turn_by_splitting]
template <class Real>
void turn_by_splitting(Top<Real>& top, Same<Real> time_step) {
  const auto [a, b, c] =
      std::array{top.inverse_moments[0], top.inverse_moments[1], top.inverse_moments[2]};
  const Vec3<Real> before = top.angular_momentum_body;
  const Vec3<Real>& L = top.angular_momentum_body;
  turn_about_axis<1>(top, time_step / 2 * ((b - a) * L[1]));
  turn_about_axis<2>(top, time_step * ((c - a) * L[2]));
  turn_about_axis<1>(top, time_step / 2 * ((b - a) * L[1]));
  top.angular_momentum_body = with_length_of(before, L);
  top.orientation = turn_exponential_body<Real>(top.orientation, a * L, time_step);
}
//! [turn_by_splitting]

}  // namespace tumble
