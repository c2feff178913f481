/// @file
/// A scene in which nearly everything acts, and what becomes of it when it is turned or mirrored as
/// a whole, or made heavier.
#pragma once

#include <support/body_bounds.hpp>
#include <tumble/air_and_water.hpp>
#include <tumble/gravity.hpp>
#include <tumble/springs.hpp>
#include <tumble/thruster.hpp>
#include <tumble/world.hpp>

namespace tumble::support {

/// A scene as it is: what another frame makes of a vector, of a turn about an axis, of an
/// orientation, and of a vector in body axes.
template <class Real>
struct SameFrame {
  Vec3<Real> vector(const Vec3<Real>& v) const { return v; }
  Vec3<Real> vector_body(const Vec3<Real>& v) const { return v; }
  Vec3<Real> spin_body(const Vec3<Real>& v) const { return v; }
  Quaternion<Real> orientation(const Quaternion<Real>& q) const { return q; }
};

/// The scene turned as a whole. In body axes nothing changes.
template <class Real>
struct TurnedFrame : SameFrame<Real> {
  Quaternion<Real> turn;
  Vec3<Real> vector(const Vec3<Real>& v) const { return rotate<Real>(turn, v); }
  Quaternion<Real> orientation(const Quaternion<Real>& q) const { return turn * q; }
};

/// The scene in a mirror that stands perpendicular to one axis, in the world and in every body. A
/// turn keeps its part along that axis and loses the sign of the others.
template <class Real>
struct MirroredFrame {
  int axis;
  Vec3<Real> vector(Vec3<Real> v) const {
    v[axis] = -v[axis];
    return v;
  }
  Vec3<Real> vector_body(const Vec3<Real>& v) const { return vector(v); }
  Vec3<Real> spin_body(const Vec3<Real>& v) const { return -vector(v); }
  Quaternion<Real> orientation(const Quaternion<Real>& q) const {
    return {q.real, spin_body(q.imaginary)};
  }
};

/// A body as another frame sees it, `scale` times as heavy.
template <class Real, class Frame>
RigidBody<Real> seen(RigidBody<Real> body, const Frame& frame, Same<Real> scale = 1) {
  body.centre.position = frame.vector(body.centre.position);
  body.centre.velocity = frame.vector(body.centre.velocity);
  body.centre.inverse_mass /= scale;
  body.top.orientation = frame.orientation(body.top.orientation);
  body.top.angular_momentum_body = scale * frame.spin_body(body.top.angular_momentum_body);
  body.top.inverse_moments /= scale;
  return body;
}

/// Two bricks with gravity, wind, Magnus' force, springs, a thruster and damping: all lengths,
/// speeds and forces at most 10.
template <class Real, class Frame>
World<Real> scene_with(const RigidBody<Real>& first, const RigidBody<Real>& second,
                       const Frame& frame, Same<Real> scale = 1) {
  World<Real> world(steps_per_second(64));
  const BodyHandle a = world.add("first", seen(first, frame, scale));
  const BodyHandle b = world.add("second", seen(second, frame, scale));
  const Spring<Real> spring{.stiffness = 4 * scale, .damping = scale / 8, .rest_length = 1};
  const Vec3<Real> wind = frame.vector({1, -2, Real(0.5)});
  world.add(Gravity<Real>{.gravity = frame.vector({1, 2, -4})});
  world.add(QuadraticDrag<Real>{.coefficient = scale / 16, .wind = wind});
  world.add(Magnus<Real>{.strength = scale / 16, .wind = wind});
  world.add(SpringToPoint<Real>{.spring = spring,
                                .anchor = frame.vector({3, 1, 2}),
                                .attachment = frame.vector_body({1, 0, Real(0.5)})},
            {a});
  world.add(SpringBetween<Real>{.spring = spring,
                                .attachment_first = frame.vector_body({0, 1, Real(0.5)}),
                                .attachment_second = frame.vector_body({1, 1, 0})},
            {a, b});
  world.add(Thruster<Real>{.force_body = scale * frame.vector_body({1, 2, 3}),
                           .point = frame.vector_body({0, 1, 1})},
            {b});
  world.add(LinearDamping<Real>{.rate = Real(0.25)});
  world.add(AngularDamping<Real>{.rate = Real(0.25)});
  return world;
}

}  // namespace tumble::support
