/// @file
/// Between a top's body axes, in which its state is kept, and the world's, in which engines keep
/// angular velocity and take torques.
#pragma once

#include <cmath>
#include <peers/peers.hpp>

namespace peers {

using Triple = std::array<double, 3>;
using Quaternion = std::array<double, 4>;  ///< w, x, y, z

inline Quaternion orientation_of(const TopState& state) {
  return {state[0], state[1], state[2], state[3]};
}

/// q v q*: from body axes to the world's.
inline Triple rotated(const Quaternion& q, const Triple& v) {
  const auto [w, x, y, z] = q;
  const double a = 2 * (y * v[2] - z * v[1]), b = 2 * (z * v[0] - x * v[2]),
               c = 2 * (x * v[1] - y * v[0]);
  return {v[0] + w * a + (y * c - z * b), v[1] + w * b + (z * a - x * c),
          v[2] + w * c + (x * b - y * a)};
}

/// rad/s, world axes.
inline Triple angular_velocity_of(const TopProblem& problem) {
  const auto& [i, L] = std::pair(problem.inverse_moments,
                                 Triple{problem.start[4], problem.start[5], problem.start[6]});
  return rotated(orientation_of(problem.start), {i[0] * L[0], i[1] * L[1], i[2] * L[2]});
}

/// The state with this orientation and angular velocity (rad/s, world axes).
inline TopState state_of(const TopProblem& problem, const Quaternion& q, const Triple& velocity) {
  const auto [w, x, y, z] = q;
  const Triple in_body = rotated({w, -x, -y, -z}, velocity);
  const auto& i = problem.inverse_moments;
  return {w, x, y, z, in_body[0] / i[0], in_body[1] / i[1], in_body[2] / i[2]};
}

/// N m, world axes, where the body's z axis points along `axis`.
inline Triple torque_on(const TopProblem& problem, const Triple& axis, double time) {
  switch (problem.torque) {
    case Torque::weight:
      return {-problem.weight_times_arm * axis[1], problem.weight_times_arm * axis[0], 0};
    case Torque::drive:
      return {0.6 * std::cos(2 * time), 0.4 * std::sin(3 * time), 0.3};
    case Torque::none:
      break;
  }
  return {};
}

}  // namespace peers
