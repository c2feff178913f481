/// @file
/// Motions of tops with locked axes whose end is known in closed form.
#pragma once

#include <array>
#include <support/exact_motion.hpp>
#include <support/orders.hpp>

namespace tumble::support {

/// The six ways to lock one axis or two.
inline constexpr std::array<std::array<bool, 3>, 6> lockings = {{{true, false, false},
                                                                 {false, true, false},
                                                                 {false, false, true},
                                                                 {false, true, true},
                                                                 {true, false, true},
                                                                 {true, true, false}}};

/// Three unequal moments, askew, with some of the axes locked.
template <class Real>
Top<Real> askew(const std::array<bool, 3>& locked) {
  Top<Real> top{.orientation = normalized(Quaternion<Real>{1, {2, -3, 4}}),
                .inverse_moments = {1, Real(0.5), Real(0.25)}};
  for (int axis = 0; axis < 3; ++axis)
    if (locked[static_cast<std::size_t>(axis)]) lock_axis(top, axis);
  return top;
}

/// A weight on a crooked arm: it pulls about every axis of the body.
struct CrookedWeight {
  void operator()(Top<Wide>& top, Wide) const {
    top.torque = rotate(top.orientation, arm).cross(Vec3<Wide>(0, 0, -3));
  }
  Vec3<Wide> arm = {0.5L, -0.25L, 0.75L};
};

/// The torque of a motor that turns a top about a fixed line of the body, n, at 2 + 3/2 sin 2t
/// rad/s, and pushes about the locked axes as hard, which their bearings take on. They take on
/// L × ω as well, which is not zero where one axis is locked.
template <class Real>
struct Motor {
  explicit Motor(const Top<Real>& top)
      : line(free_part<Real>(top, Vec3<Real>(Real(0.6), Real(-0.8), Real(0.5))).normalized()),
        momentum(moments_of(top).cwiseProduct(line)),
        along_locked(Vec3<Real>::Constant(2) - free_part<Real>(top, Vec3<Real>::Constant(2))) {}

  void operator()(Top<Real>& top, Real time) const {
    const Vec3<Real> torque_body = 3 * std::cos(2 * time) * (momentum + along_locked);
    top.torque = rotate(top.orientation, torque_body);
  }

  Vec3<Real> line, momentum, along_locked;
};

/// A top that a motor turns, from its start at 2 rad/s, and where it is at the end.
template <class Real>
Problem<Top<Real>, Motor<Real>> motored(const std::array<bool, 3>& locked) {
  const Top<Real> top = askew<Real>(locked);
  Problem<Top<Real>, Motor<Real>> problem{"", top, Motor<Real>(top), 2};
  problem.start.angular_momentum_body = 2 * problem.evaluate_forces.momentum;
  return problem;
}
template <class Real>
Top<Wide> end_of(const Problem<Top<Real>, Motor<Real>>& problem) {
  const Wide time = problem.seconds, angle = 2 * time + (1 - std::cos(2 * time)) * 3 / 4;
  Top<Wide> end = exactly(problem.start);
  const Vec3<Wide> turn = angle * problem.evaluate_forces.line.template cast<Wide>();
  end.orientation = end.orientation * quaternion_of_rotation_vector(turn);
  end.angular_momentum_body *= (2 + 1.5L * std::sin(2 * time)) / 2;
  return end;
}

/// The weight, 3 N, of a pendulum: a top locked about two axes. Its centre of mass is 1 m off the
/// third, and half a metre along it.
template <class Real>
struct PendulumWeight {
  void operator()(Top<Real>& top, Real) const {
    top.torque = rotate(top.orientation, arm).cross(Vec3<Real>(0, 0, -3));
  }
  Vec3<Real> arm;
};

/// A pendulum free about the body axis `free`, let go at rest 2 rad from where it would hang.
template <class Real>
Problem<Top<Real>, PendulumWeight<Real>> pendulum(int free) {
  const int along = (free + 1) % 3, across = (free + 2) % 3;
  Top<Real> top{.inverse_moments = {1, Real(0.5), Real(0.25)}};
  lock_axis(top, along);
  lock_axis(top, across);
  Mat3<Real> hanging = Mat3<Real>::Zero();  // the free axis lies along y, the arm down
  hanging(1, free) = 1;
  hanging(2, along) = -1;
  hanging(0, across) = -1;
  Vec3<Real> axis = Vec3<Real>::Unit(free);
  top.orientation = quaternion_of(hanging) * quaternion_about(axis, Real(2));
  return {"", top, {Vec3<Real>::Unit(along) + axis / 2}, 2};
}
/// The sine of half its angle is that of half the largest, times sn(K + rate t), where the rate is
/// that of a small swing (Landau and Lifshitz, Mechanics, section 11, problem 1).
template <class Real>
Top<Wide> end_of(const Problem<Top<Real>, PendulumWeight<Real>>& problem, int free) {
  Top<Wide> end = exactly(problem.start);
  const Wide sine = std::sin(1.0L), m = sine * sine, cosine = std::cos(1.0L);
  const exact::Jacobi<Wide> jacobi(m, cosine * cosine);
  const Wide rate = std::sqrt(3 * end.inverse_moments[free]);
  const auto [sn, cn, dn] = jacobi.at(jacobi.quarter_period() + rate * problem.seconds);
  const Vec3<Wide> turn = (2 * std::asin(sine * sn) - 2) * Vec3<Wide>::Unit(free);
  end.orientation = end.orientation * quaternion_of_rotation_vector(turn);
  end.angular_momentum_body[free] = 2 * sine * rate * cn / end.inverse_moments[free];
  return end;
}

/// What so many steps round, in apart()'s measure. A row has 35 portions at most. In each the
/// orientation rounds 40 times (three times a component of a product of quaternions, thrice, and as
/// many for the norm), and L 60 times, by the torque and the turns of both. L is 14 kg m²/s at
/// most, and what it is off by turns the top for the rest of the run, which lasts for 7 rad at
/// most.
template <class Real>
Wide rounding_of(int steps) {
  return static_cast<Wide>(steps * 35 * (40 + 60 * (7 + 14))) * unit_roundoff<Real>;
}

/// The angle between two orientations (rad), and how far apart L is: both, since on its way through
/// zero an angle alone may be small by chance.
inline Wide apart(const Top<Wide>& a, const Top<Wide>& b) {
  return difference(a, b) + (a.angular_momentum_body - b.angular_momentum_body).norm();
}

}  // namespace tumble::support
