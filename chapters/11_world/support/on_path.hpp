/// @file
/// An effect that leads a body along a path.
#pragma once

#include <tumble/forms.hpp>

namespace tumble::support {

//! [on_path]
/// Gives the velocity that leads to where the path t² is at the end of the step, m along x.
template <class Real>
struct OnPath {
  static constexpr std::string_view name = "lift";
  static constexpr Phase phase = Phase::damping;  // after the kicks and the blows
  Vec3<Real> velocity(const Particle<Real>& centre, const StepTime<Real>& at) const {
    const Real end = at.time + at.time_step;
    return (Vec3<Real>(end * end, 0, 0) - centre.position) / at.time_step;
  }
};
//! [on_path]

}  // namespace tumble::support
