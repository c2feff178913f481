/// @file
/// Springs with dampers, from a body to a point of the world and from body to body.
#pragma once

#include <tumble/any_effect.hpp>

namespace tumble {

/// What a spring is made of: a stiffness, a damper beside it and the length at which it rests.
template <class Real>
struct Spring {
  Real stiffness = 0;       ///< k, N/m, 0 or more
  Real damping = 0;         ///< c, N s/m, 0 or more
  Real rest_length = 0;     ///< l₀, m, 0 or more
  bool only_pulls = false;  ///< a tether: slack where it is shorter than at rest, and never pushes
};

/// The force (N) on the one end of a spring: −(k (l − l₀) + c l̇) n, where n leads along `extent`
/// (m) from the other end to this one and `rate` is how fast that changes (m/s). It is 0 of a
/// tether that is slack or would push, and of a spring without length, which pulls towards nowhere.
//! [spring_force]
template <class Real>
Vec3<Real> spring_force(const Spring<Real>& spring, const Vec3<Same<Real>>& extent,
                        const Vec3<Same<Real>>& rate) {
  const Real length = extent.norm();
  const Vec3<Real> n = extent / select(length == 0, Real(1), length);
  const Real stretch = length - spring.rest_length;
  const Real tension = spring.stiffness * stretch + spring.damping * dot(rate, n);
  const Real pull =
      spring.only_pulls ? select(stretch < 0 || tension < 0, Real(0), tension) : tension;
  return -pull * n;
}
//! [spring_force]

/// ½ k (l − l₀)², J; 0 of a slack tether.
template <class Real>
Real spring_energy(const Spring<Real>& spring, const Vec3<Same<Real>>& extent) {
  const Real stretch = extent.norm() - spring.rest_length;
  return spring.only_pulls && stretch < 0 ? 0 : spring.stiffness * stretch * stretch / 2;
}

/// How many derivatives of the force never jump: none of a tether, whose slope does as it becomes
/// taut.
template <class Real>
int smoothness_of(const Spring<Real>& spring) {
  return spring.only_pulls ? 0 : 9;
}

/// Throws unless stiffness, damping and rest length are finite and 0 or more.
template <class Real>
void check_spring(const Spring<Real>& spring) {
  require_not_negative("stiffness of a spring", spring.stiffness, "N/m");
  require_not_negative("damping of a spring", spring.damping, "N s/m");
  require_not_negative("rest length of a spring", spring.rest_length, "m");
}

/// The lever arm of a point that is fixed to the body: from the centre of mass, m, world axes.
template <class Real>
Vec3<Real> arm_of(const BodyState<Real>& body, const Vec3<Same<Real>>& point_body) {
  return rotate(body.top.orientation, point_body);
}

/// The velocity of that point, m/s, world axes.
template <class Real>
Vec3<Real> velocity_of_arm(const BodyState<Real>& body, const Vec3<Same<Real>>& arm) {
  return body.centre.velocity + angular_velocity_world(body.top).cross(arm);
}

/// A spring from a point of the body to a point of the world. A place in a model's axes, as scene
/// files have it, is led to body axes by point_outward(model_in_body, place)
/// of pose.hpp.
template <class Real>
struct SpringToPoint {
  Spring<Real> spring = {};                ///< how it pulls
  Vec3<Real> anchor = Vec3<Real>::Zero();  ///< where it hangs, m, world axes
  Vec3<Real> attachment =
      Vec3<Real>::Zero();       ///< where it holds the body: from its centre, m, body axes
  std::string name = "spring";  ///< what plans and errors call it

  void check() const {
    check_spring(spring);
    require_finite("anchor of a spring", anchor, "m");
    require_finite("attachment of a spring", attachment, "m");
  }
  /// Whether it pulls beside the centre of mass, so that its body must not be a point.
  bool needs_top() const { return attachment != Vec3<Real>::Zero(); }
  bool depends_on_speed() const { return spring.damping != 0; }
  int smoothness() const { return smoothness_of(spring); }
  Response<Real> response(const BodyState<Real>& body) const {
    return {.stiffness = spring.stiffness,
            .damping = spring.damping,
            .arm_first = arm_of(body, attachment),
            .force = push(body, 0).force};
  }
  bool gives_torque() const { return needs_top(); }
  std::string_view skip_reason(const BodyFlags&) const {
    return spring.stiffness == 0 && spring.damping == 0 ? "it neither pulls nor damps" : "";
  }
  //! [spring_to_point]
  Push<Real> push(const BodyState<Real>& body, Real) const {
    const Vec3<Real> arm = arm_of(body, attachment);
    const Vec3<Real> extent = body.centre.position - anchor + arm;
    const Vec3<Real> force = spring_force<Real>(spring, extent, velocity_of_arm<Real>(body, arm));
    return {.force = force, .torque = arm.cross(force)};
  }
  //! [spring_to_point]
  template <class Wide>
  SpringToPoint<Wide> broadcast() const {
    return {{spring.stiffness, spring.damping, spring.rest_length, spring.only_pulls},
            anchor.template cast<Wide>(),
            attachment.template cast<Wide>(),
            name};
  }
  Real potential_energy(const BodyState<Real>& body) const {
    return spring_energy<Real>(spring, body.centre.position - anchor + arm_of(body, attachment));
  }
};

/// A spring from a point of one body to a point of another. See SpringToPoint for their axes.
template <class Real>
struct SpringBetween {
  Spring<Real> spring = {};                           ///< how it pulls
  Vec3<Real> attachment_first = Vec3<Real>::Zero();   ///< from its centre of mass, m, body axes
  Vec3<Real> attachment_second = Vec3<Real>::Zero();  ///< from its centre of mass, m, body axes
  std::string name = "spring between bodies";         ///< what plans and errors call it

  void check() const {
    check_spring(spring);
    require_finite("first attachment of a spring", attachment_first, "m");
    require_finite("second attachment of a spring", attachment_second, "m");
  }
  /// Whether it pulls beside the first one's centre of mass, so that the first must not be a point.
  bool needs_top() const { return attachment_first != Vec3<Real>::Zero(); }
  /// The same of the second.
  bool needs_second_top() const { return attachment_second != Vec3<Real>::Zero(); }
  bool depends_on_speed() const { return spring.damping != 0; }
  int smoothness() const { return smoothness_of(spring); }
  Response<Real> response(const BodyState<Real>& first, const BodyState<Real>& second) const {
    return {.stiffness = spring.stiffness,
            .damping = spring.damping,
            .arm_first = arm_of(first, attachment_first),
            .arm_second = arm_of(second, attachment_second),
            .force = push(first, second, 0).force_on_first};
  }
  bool gives_torque() const { return needs_top() || needs_second_top(); }
  std::string_view skip_reason() const {
    return spring.stiffness == 0 && spring.damping == 0 ? "it neither pulls nor damps" : "";
  }
  //! [spring_between]
  PairPush<Real> push(const BodyState<Real>& first, const BodyState<Real>& second, Real) const {
    const Vec3<Real> arm = arm_of(first, attachment_first);
    const Vec3<Real> other_arm = arm_of(second, attachment_second);
    const Vec3<Real> extent = first.centre.position - second.centre.position + (arm - other_arm);
    const Vec3<Real> rate =
        velocity_of_arm<Real>(first, arm) - velocity_of_arm<Real>(second, other_arm);
    const Vec3<Real> force = spring_force<Real>(spring, extent, rate);
    return {.force_on_first = force,
            .torque_on_first = arm.cross(force),
            .torque_on_second = force.cross(other_arm)};
  }
  //! [spring_between]
  Real potential_energy(const BodyState<Real>& first, const BodyState<Real>& second) const {
    return spring_energy<Real>(
        spring, first.centre.position - second.centre.position +
                    (arm_of(first, attachment_first) - arm_of(second, attachment_second)));
  }
};

}  // namespace tumble
