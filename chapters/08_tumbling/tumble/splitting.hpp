#pragma once
#include <tumble/turning_rules.hpp>
namespace tumble {
/// Turns the top by `angle` about one of its body axes, L staying where it is in the world.
template <int axis, class Real>
void turn_about_axis(Top<Real>& top, Real angle) {
  constexpr int next = (axis + 1) % 3, last = (axis + 2) % 3;
  const Real sine_half = std::sin(angle / 2), cosine_half = std::cos(angle / 2);
  const Real sine = 2 * sine_half * cosine_half, versine = 2 * sine_half * sine_half;
  Vec3<Real>& L = top.angular_momentum_body;
  const Real n = L[next], l = L[last];
  L[next] = n + (sine * l - versine * n);
  L[last] = l - (sine * n + versine * l);
  Quaternion<Real>& q = top.orientation;
  const Real w = q.real, qa = q.imaginary[axis], qn = q.imaginary[next], ql = q.imaginary[last];
  q.real = cosine_half * w - sine_half * qa;
  q.imaginary[axis] = cosine_half * qa + sine_half * w;
  q.imaginary[next] = cosine_half * qn + sine_half * ql;
  q.imaginary[last] = cosine_half * ql - sine_half * qn;
}
template <class Real>
void turn_splitting_axes(Top<Real>& top, Same<Real> h) {
  const Vec3<Real>& i = top.inverse_moments; const Vec3<Real>& L = top.angular_momentum_body;
  turn_about_axis<0>(top, h / 2 * (i[0] * L[0]));
  turn_about_axis<1>(top, h / 2 * (i[1] * L[1]));
  turn_about_axis<2>(top, h * (i[2] * L[2]));
  turn_about_axis<1>(top, h / 2 * (i[1] * L[1]));
  turn_about_axis<0>(top, h / 2 * (i[0] * L[0]));
  top.orientation = normalized(top.orientation);
}
template <class Real>
void turn_splitting_sphere(Top<Real>& top, Same<Real> h) {
  const Vec3<Real>& i = top.inverse_moments; const Vec3<Real>& L = top.angular_momentum_body;
  const Real rb = i[1] - i[0], rc = i[2] - i[0];
  turn_about_axis<1>(top, h / 2 * (rb * L[1]));
  turn_about_axis<2>(top, h * (rc * L[2]));
  turn_about_axis<1>(top, h / 2 * (rb * L[1]));
  const Vec3<Real> angle = h * i[0] * L;
  top.orientation = normalized(top.orientation * quaternion_of_rotation_vector(angle));
}
}
