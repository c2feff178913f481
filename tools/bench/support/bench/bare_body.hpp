/// @file
/// One body without a world: what its kick, its drift and its turn take, called one after another.
#pragma once

#include <support/bench/setting.hpp>
#include <tumble/make_rigid_body.hpp>
#include <tumble/solids.hpp>
#include <tumble/tumbling.hpp>

namespace tumble::support::bench {

/// The box number n, as it begins.
template <class Real>
RigidBody<Real> box_number(std::size_t n) {
  static const RigidBody<Real> at_rest =
      make_rigid_body<Real>(
          "box", mass_properties(Box<Real>{vector_of<Real>(edges)}, static_cast<Real>(mass)))
          .body;
  RigidBody<Real> body = at_rest;
  const Start start = start_of(n);
  body.centre.position = vector_of<Real>(start.position);
  body.centre.velocity = vector_of<Real>(start.velocity);
  set_angular_velocity_world(body.top, vector_of<Real>(start.angular_velocity));
  return body;
}

/// A box that tumbles under a steady torque.
template <class Real>
class BareBody {
 public:
  explicit BareBody(const Setting& setting)
      : body_(box_number<Real>(0)), time_step_(static_cast<Real>(setting.time_step())) {
    body_.top.torque = vector_of<Real>(torque);
  }
  void run(int steps) {
    for (int step = 0; step < steps; ++step) {
      kick(body_.top, time_step_);
      drift(body_.centre, time_step_);
      turn_by_splitting(body_.top, time_step_);
    }
  }
  Motion motion(std::size_t) const {
    return {triple_of(body_.centre.position), triple_of(body_.centre.velocity),
            triple_of(angular_velocity_world(body_.top))};
  }

 private:
  RigidBody<Real> body_;
  Real time_step_;
};

}  // namespace tumble::support::bench
