/// @file
/// The gyroscope of the chapter's page, and one step of it by any rule.
#pragma once

#include <support/rules.hpp>
#include <tumble/exact/heavy_top.hpp>
#include <tumble/gyroscope.hpp>

namespace tumble::support {

/// A toy's flywheel, 6 cm across and 1 cm thick, 4 cm above the tip of a shaft without mass.
constexpr Cylinder<double> flywheel = {.radius = 0.03, .height = 0.01};
constexpr double flywheel_mass = 0.15, flywheel_above_tip = 0.04, flywheel_gravity = 9.81;

template <class Real>
Gyroscope<Real> toy_gyroscope() {
  const Cylinder<Real> wheel{Real(flywheel.radius), Real(flywheel.height)};
  return on_its_tip(mass_properties(wheel, Real(flywheel_mass)), Real(flywheel_above_tip),
                    Real(flywheel_gravity));
}

/// One step: the weight's torque kicks, then the top turns freely by `turn`.
//! [step_of]
template <class Real>
void step(Top<Real>& top, const Gyroscope<Real>& gyroscope,
          void (*turn)(Top<Same<Real>>&, Same<Real>), Same<Real> h) {
  clear_torque(top);
  add_weight(top, gyroscope);
  kick(top, h);
  turn(top, h);
}
//! [step_of]

/// The exact motion of the top, by elliptic functions.
template <class Real>
exact::HeavyTop<Real> exactly_spinning(const Top<Real>& top, const Gyroscope<Real>& gyroscope) {
  return exact::HeavyTop<Real>(top, Vec3<Real>(0, 0, -pull_of(gyroscope)));
}

/// The tilt of the top's axis from upright, rad.
template <class Real>
Real tilt_of(const Top<Real>& top) {
  const Vec3<Real> axis = axis_of(top);
  return std::atan2(std::hypot(axis.x(), axis.y()), axis.z());
}

/// The direction of its horizontal part, rad, −π to π; 0 where set_spinning() leaves it.
template <class Real>
Real azimuth_of(const Top<Real>& top) {
  const Vec3<Real> axis = axis_of(top);
  return std::atan2(axis.x(), -axis.y());
}

}  // namespace tumble::support
