/// @file
/// Other libraries on the chapter's problems. They know nothing of Tumble: each is called as its
/// manual says, with plain arrays between it and us, and compiled as its users would.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace peers {

/// A top, free or under a torque: the quaternion (w, x, y, z), then L in body axes.
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

/// A top to simulate.
struct TopProblem {
  Torque torque;
  double weight_times_arm;  ///< N m
  std::array<double, 3> inverse_moments;
  TopState start;
  double seconds;
};

/// Boost.Odeint: the equations written out on plain arrays, as its manual does it.
std::vector<Peer<TopState>> odeint_on_top(const TopProblem& problem);

/// `parameters`: the stiffness, the star's strength, or gravity and the rate of the drag.
std::vector<Peer<PointState>> odeint_on_point(Force force, const std::array<double, 2>& parameters,
                                              const PointState& start, double seconds);

/// Bullet's integration functions, in double.
std::vector<Peer<TopState>> bullet_on_top(const TopProblem& problem);
/// ODE's bodies in a world of their own.
std::vector<Peer<TopState>> ode_on_top(const TopProblem& problem);
/// Simbody's integrators on its ball joint.
std::vector<Peer<TopState>> simbody_on_top(const TopProblem& problem);

/// Those that were there when this was compiled; the others are left out.
struct Library {
  std::string name;
  std::vector<Peer<TopState>> (*on_top)(const TopProblem& problem);
};
const std::vector<Library>& libraries();

}  // namespace peers
