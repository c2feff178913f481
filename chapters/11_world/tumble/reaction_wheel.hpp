/// @file
/// A wheel inside a body, which a motor drives.
#pragma once

#include <algorithm>
#include <limits>
#include <tumble/effect.hpp>

namespace tumble {

/// A wheel that spins about an axis of its body, with the momentum h beside what it has from
/// turning along with the body. What the motor gives to the wheel, the body loses.
///
/// The wheel is balanced: how it turns changes neither the centre of mass nor the inertia of the
/// body, in both of which it counts as if it stood still.
template <class Real>
struct ReactionWheel {
  Vec3<Real> axis = {0, 0, 1};  ///< a, of length 1, body axes
  Real momentum = 0;            ///< h before the motor runs, relative to the body, kg m²/s
  Real torque = 0;              ///< ḣ while it runs, N m
  Real from = 0;                ///< s, when the motor starts
  Real until = std::numeric_limits<Real>::infinity();  ///< s, when it stops: not before it starts
  std::string name = "reaction wheel";                 ///< what plans and errors call it

  /// What the wheel holds at `time` (s), kg m²/s, body axes.
  //! [reaction_wheel]
  Vec3<Real> rotor_angular_momentum_body(Real time) const {
    return (momentum + torque * (std::clamp(time, from, until) - from)) * axis;
  }
  //! [reaction_wheel]
  std::string_view skip_reason(const BodyFlags&) const {
    return momentum == 0 && torque == 0 ? "the wheel stands still" : "";
  }

  /// @throws std::invalid_argument unless the axis has length 1, `until` is not before `from`, and
  /// the rest is finite.
  void check() const {
    require_finite("axis of a reaction wheel", axis, "");
    const Real slack = 8 * std::numeric_limits<Real>::epsilon();  // as renormalized() has it
    if (!(std::abs(axis.squaredNorm() - 1) <= slack))
      reject("axis of a reaction wheel", axis, "", "it must have length 1");
    require_finite("momentum of a reaction wheel", momentum, "kg m^2/s");
    require_finite("torque of a reaction wheel", torque, "N m");
    require_finite("start of a reaction wheel", from, "s");
    if (!(until >= from))
      reject("end of a reaction wheel", until, "s", "it must not lie before the start");
    if (until <= std::numeric_limits<Real>::max())
      require_finite("momentum of a reaction wheel at the end", momentum + torque * (until - from),
                     "kg m^2/s");
  }
  /// Where the motor starts and stops, the momentum has a kink.
  int smoothness() const { return torque == 0 ? 9 : 0; }
};

}  // namespace tumble
