/// @file
/// What a body must be to come into a world.
#pragma once

#include <tumble/make_rigid_body.hpp>

namespace tumble {

/// Throws unless a world can hold such a centre, or such a top. `name` is what the error calls it.
template <class Real>
void check_body(const std::string& name, const Particle<Real>& centre) {
  require_finite(name + ": position", centre.position, "m");
  require_finite(name + ": velocity", centre.velocity, "m/s");
  require_not_negative(name + ": inverse mass", centre.inverse_mass, "1/kg");
}
template <class Real>
void check_body(const std::string& name, const Top<Real>& top) {
  checked_orientation(top.orientation, name + ": orientation");
  require_finite(name + ": angular momentum", top.angular_momentum_body, "kg m^2/s");
  require_finite(name + ": inverse moments", top.inverse_moments, "1/(kg m^2)");
  if (top.inverse_moments.minCoeff() < 0)
    reject(name + ": inverse moments", top.inverse_moments, "1/(kg m^2)", "each must be 0 or more");
  if (free_part<Real>(top, top.angular_momentum_body) != top.angular_momentum_body)
    reject(name + ": angular momentum", top.angular_momentum_body, "kg m^2/s, body axes",
           "it must be 0 about a locked axis");
}

}  // namespace tumble
