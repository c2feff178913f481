/// @file
/// Boost.Odeint on the chapter's problems. It knows nothing of Tumble: the equations are written
/// out on plain arrays, as its manual does it, and compiled as its users would.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace peers {

/// A free top, also under a torque: the quaternion (w, x, y, z), then L in body axes.
using TopState = std::array<double, 7>;
/// Position, then velocity.
using PointState = std::array<double, 6>;

template <class State>
struct Peer {
  std::string name;
  bool chooses_steps;
  std::function<State(double knob)> run;  ///< the state at the end; knob: steps, or tolerance
};

enum class Torque { none, weight, drive };
enum class Force { spring, star, gravity_and_drag };

/// `parameter`: the weight times the arm, N m.
std::vector<Peer<TopState>> odeint_on_top(Torque torque, double parameter,
                                          const std::array<double, 3>& inverse_moments,
                                          const TopState& start, double seconds);

/// `parameters`: the stiffness, the star's strength, or gravity and the rate of the drag.
std::vector<Peer<PointState>> odeint_on_point(Force force, const std::array<double, 2>& parameters,
                                              const PointState& start, double seconds);

}  // namespace peers
