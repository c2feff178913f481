/// @file
/// A box for checks that only need some body that can move and tumble.
#pragma once

#include <tumble/make_rigid_body.hpp>
#include <tumble/solids.hpp>

namespace tumble::support {

/// 1 m, 2 m and 3 m long, 2 kg, at rest at `place` (m).
template <class Real>
RigidBody<Real> box_body(const Vec3<Real>& place) {
  return make_rigid_body<Real>("box", mass_properties(Box<Real>{{1, 2, 3}}, 2), {place}).body;
}

}  // namespace tumble::support
