/// @file
/// Rotors inside bodies: how what spins inside shares its angular momentum with what it is
/// built into.
#pragma once

#include <tumble/splitting.hpp>
#include <tumble/terms.hpp>

namespace tumble {

/// What is done to a top with a rotor in each drift, in this order; the turning lies in the middle.
enum class RotorAct {
  join,         ///< L ← L + H: the top turns with all of the momentum
  turn_before,  ///< half a drift's turn about −I⁻¹ H
  turn_after,   ///< the other half
  leave         ///< L ← L − H: the rotor keeps what it holds by then
};

/// Does `act` to a top. H (`momentum`) in kg m²/s, body axes, `time_step` in s, of the whole drift.
///
/// With Π = L + H the energy of the body is ½ (Π − H)·I⁻¹(Π − H) = ½ Π·I⁻¹Π − Π·I⁻¹H + a constant.
/// The first part alone is that of a free top with the momentum Π, and the second turns the body
/// about −I⁻¹H, while Π stands still in the world. See Hughes, Spacecraft Attitude Dynamics (1986),
/// on gyrostats.
///
/// Where an axis is locked, L turns with the body, and what locks the axis bears all of Π × ω but
/// A L, the part of H × I⁻¹L about the free axes. There a drift turns by the mean M of L before and
/// after it: M − h/2 A M is the L before, and M + h/2 A M that after. As A² is −1 times a number,
/// (h/2 A)² = −d, the first makes M = (L + h/2 A L)/(1 + d). H's part about the free axes is
/// added and taken away by the half turns, and not by join and leave: if L held it there, the A of
/// another rotor would act on it.
//! [rotor_act]
template <class Real>
void act_on(Top<Real>& top, RotorAct act, const Vec3<Same<Real>>& momentum, Same<Real> time_step) {
  const Vec3<Real>& inverse = top.inverse_moments;
  Vec3<Real>& L = top.angular_momentum_body;
  const auto is_free = inverse.x() != 0 && inverse.y() != 0 && inverse.z() != 0;
  if (act == RotorAct::turn_before || act == RotorAct::turn_after) {
    const Vec3<Real> H = free_part<Real>(top, momentum);
    const Vec3<Real> turn = -(time_step / 2) * inverse.cwiseProduct(H);
    const Quaternion<Real> q = quaternion_of_rotation_vector(turn);
    const Vec3<Real> carried = with_length_of<Real>(L, rotate_back(q, L));
    const Vec3<Real> shared = act == RotorAct::turn_before ? Vec3<Real>(L + H) : Vec3<Real>(L - H);
    top.orientation = renormalized(top.orientation * q);
    for (int axis = 0; axis < 3; ++axis) L[axis] = select(is_free, carried[axis], shared[axis]);
    return;
  }
  const Vec3<Real> H = select(is_free, Real(1), Real(0)) * momentum;
  const Vec3<Real> c = select(is_free, Real(0), time_step / 2) * momentum;
  const Real d = c.x() * c.x() * inverse.y() * inverse.z() +
                 c.y() * c.y() * inverse.z() * inverse.x() +
                 c.z() * c.z() * inverse.x() * inverse.y();
  L += free_part<Real>(top, c.cross(inverse.cwiseProduct(L)));
  if (act == RotorAct::join)
    L = L / (1 + d) + H;
  else
    L -= H;
}
//! [rotor_act]

/// The time (s) at which `act` is done: the beginning of the drift or its end, which of a drift
/// backwards is the earlier one.
template <class Real>
Real time_of(RotorAct act, const StepTime<Real>& drift) {
  return act < RotorAct::turn_after ? drift.time : drift.time + drift.time_step;
}

}  // namespace tumble
