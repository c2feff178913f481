/// @file
/// The classical Runge–Kutta rule on turns instead of numbers.
#pragma once

#include <tumble/tumbling.hpp>

namespace tumble {

/// How the rotation vector of the turn since the step began, v (rad), changes while the body turns
/// at ω (rad/s, body axes): v̇ = ω + ½ v × ω + v × (v × ω)/12 + … The rest is of fourth order in v,
/// too small for a rule of fourth order to see.
//! [rate_of_turn]
template <class Real>
Vec3<Real> rate_of_turn(const Vec3<Real>& turn, const Vec3<Same<Real>>& angular_velocity) {
  const Vec3<Real> across = turn.cross(angular_velocity);
  return angular_velocity + across / 2 + turn.cross(across) / 12;
}
//! [rate_of_turn]

/// The rule of Runge, Kutta and Munthe-Kaas. L stands still in the world, so the turn v alone is
/// unknown: ω = I⁻¹ e^(−v) L. The vector v is stepped by the classical rule, from zero; then one
/// turn by it is made. So the orientation stays a rotation and L stays in the world, up to the
/// limit of quaternion_of_rotation_vector(), which the stages can exceed from tens of radians a
/// step on: there the result is NaN.
//! [turn_by_lie_runge_kutta]
template <class Real>
void turn_by_lie_runge_kutta(Top<Real>& top, Same<Real> time_step) {
  const Vec3<Real> L = top.angular_momentum_body;
  const auto rate = [&](const Vec3<Real>& turn) -> Vec3<Real> {
    const Vec3<Real> L_there = rotate_back(quaternion_of_rotation_vector(turn), L);
    return time_step * rate_of_turn<Real>(turn, top.inverse_moments.cwiseProduct(L_there));
  };
  const Vec3<Real> first = time_step * angular_velocity_body(top);
  const Vec3<Real> second = rate(first / 2);
  const Vec3<Real> third = rate(second / 2);
  const Vec3<Real> fourth = rate(third);
  const Quaternion<Real> turn =
      quaternion_of_rotation_vector<Real>(first / 6 + second / 3 + third / 3 + fourth / 6);
  top.angular_momentum_body = rotate_back(turn, L);
  top.orientation = renormalized(top.orientation * turn);
}
//! [turn_by_lie_runge_kutta]

namespace detail {

/// What changes under torque: the turn, and L in the axes that the body had when the step began.
template <class Real>
struct TurnAndMomentum {
  Vec3<Real> turn, momentum;
};

}  // namespace detail

/// What the bearings of locked axes push with (N m, world axes), so that L about those axes stays
/// 0: they take on the torque about them, and L × ω about them, which the axes of the world would
/// see as L turning along with the body.
//! [bearing_torque]
template <class Real>
Vec3<Real> bearing_torque(const Top<Real>& top) {
  const Vec3<Real> unborne = rotate_back(top.orientation, top.torque) + gyroscopic_torque(top);
  return rotate<Real>(top.orientation, free_part(top, unborne) - unborne);
}
//! [bearing_torque]

/// The same with torque. In the axes of the step's start L changes by the torques alone, the
/// bearings' among them, so where there is none it is kept to the last digit. `evaluate_forces` as
/// in step_by_runge_kutta().
template <class Real, class Forces>
void turn_by_lie_runge_kutta(Top<Real>& top, const Forces& evaluate_forces, Same<Real> time,
                             Same<Real> time_step) {
  using State = detail::TurnAndMomentum<Real>;
  const Quaternion<Real> start = top.orientation;
  const bool borne = (top.inverse_moments.array() == 0).any();
  const auto go = [&](const State& by) {
    const Quaternion<Real> turn = quaternion_of_rotation_vector(by.turn);
    top.orientation = start * turn;
    top.angular_momentum_body = free_part(top, rotate_back(turn, by.momentum));
  };
  const auto rate = [&](const State& by) -> State {
    const Vec3<Real> torque = borne ? top.torque + bearing_torque(top) : top.torque;
    return {time_step * rate_of_turn(by.turn, angular_velocity_body(top)),
            time_step * rotate_back(start, torque)};
  };
  const State begin = {Vec3<Real>::Zero(), top.angular_momentum_body};
  State sum = begin, there = begin;
  const auto add_stage = [&](Real weight, Real ahead) {
    const State change = rate(there);
    sum.turn += weight * change.turn;
    sum.momentum += weight * change.momentum;
    there = {ahead * change.turn, begin.momentum + ahead * change.momentum};
  };
  add_stage(Real(1) / 6, Real(1) / 2);
  for (const Real ahead : {Real(1) / 2, Real(1)}) {
    go(there);
    evaluate_forces(top, time + time_step / 2);
    add_stage(Real(1) / 3, ahead);
  }
  go(there);
  evaluate_forces(top, time + time_step);
  add_stage(Real(1) / 6, 0);
  go(sum);
  top.orientation = renormalized(top.orientation);
  evaluate_forces(top, time + time_step);
}

}  // namespace tumble
