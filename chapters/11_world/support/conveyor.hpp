/// @file
/// A motion of a user's own, for worlds of both kinds.
#pragma once

#include <string_view>
#include <tumble/step_plan.hpp>

namespace tumble::support {

/// Whatever lies on it is carried along the x axis, at a quarter of a metre a second.
struct Conveyor {
  static constexpr std::string_view name = "conveyor";
  static constexpr Phase phase = Phase::drift;
  static constexpr Quantities reads = quantity::none, writes = quantity::position;
  template <class Real>
  void operator()(Particle<Real>& centre, const Real& time_step) const {
    centre.position.x() += time_step / 4;
  }
};

}  // namespace tumble::support
