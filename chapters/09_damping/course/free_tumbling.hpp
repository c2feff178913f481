/// @file
/// How a free body tumbles, for demonstrations: classical Runge–Kutta on L̇ = L × ω in body axes.
/// Chapter 8 derives the equation and has better rules.
#pragma once

#include <tumble/top.hpp>

namespace tumble::course {

template <class Real>
void tumble_on(Top<Real>& top, Same<Real> time_step) {
  using Vector = Vec3<Real>;
  const auto rate = [&top](const Vector& momentum) {
    return Vector(momentum.cross(top.inverse_moments.cwiseProduct(momentum)));
  };
  Vector& momentum = top.angular_momentum_body;
  const Vector first = rate(momentum);
  const Vector second = rate(momentum + time_step / 2 * first);
  const Vector third = rate(momentum + time_step / 2 * second);
  const Vector fourth = rate(momentum + time_step * third);
  momentum += time_step / 6 * (first + 2 * second + 2 * third + fourth);
}

/// A top with principal moments of 1, 2 and 3 kg m² and angular velocity ω (rad/s, body axes).
template <class Real>
Top<Real> uneven_top(const Vec3<Real>& angular_velocity) {
  Top<Real> top;
  top.inverse_moments = Vec3<Real>(1, Real(1) / 2, Real(1) / 3);
  set_angular_velocity_body(top, angular_velocity);
  return top;
}

}  // namespace tumble::course
