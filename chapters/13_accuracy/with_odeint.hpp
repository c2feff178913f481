/// @file
/// Boost.Odeint among the contestants, in double, as in its examples.
#pragma once

#include <course/contest.hpp>
#include <peers/odeint.hpp>

namespace tumble::course {

template <class Body, class Gather>
void append_odeint(std::vector<Contestant<Body>>&, const Problem<Body, Gather>&, ...) {}

template <class Gather>
void append_odeint(std::vector<Contestant<Topd>>& list, const Problem<Topd, Gather>& problem,
                   peers::Torque torque, double parameter) {
  const Topd start = problem.start;
  const auto& [q, v] = start.orientation;
  const Vec3d& L = start.angular_momentum_body;
  const Vec3d& i = start.inverse_moments;
  for (const auto& peer :
       peers::odeint_on_top(torque, parameter, {i[0], i[1], i[2]},
                            {q, v[0], v[1], v[2], L[0], L[1], L[2]}, problem.seconds))
    list.push_back({"Odeint " + peer.name, "Odeint", peer.chooses_steps, [=](double knob) {
                      const auto [w, x, y, z, L0, L1, L2] = peer.run(knob);
                      Topd top = start;
                      top.orientation = {w, {x, y, z}};
                      top.angular_momentum_body = {L0, L1, L2};
                      return top;
                    }});
}

template <class Gather>
void append_odeint(std::vector<Contestant<Particled>>& list,
                   const Problem<Particled, Gather>& problem, peers::Force force,
                   const std::array<double, 2>& parameters) {
  const Particled start = problem.start;
  const Vec3d &x = start.position, &v = start.velocity;
  for (const auto& peer : peers::odeint_on_point(
           force, parameters, {x[0], x[1], x[2], v[0], v[1], v[2]}, problem.seconds))
    list.push_back({"Odeint " + peer.name, "Odeint", peer.chooses_steps, [=](double knob) {
                      const auto [x0, x1, x2, v0, v1, v2] = peer.run(knob);
                      Particled particle = start;
                      particle.position = {x0, x1, x2};
                      particle.velocity = {v0, v1, v2};
                      return particle;
                    }});
}

}  // namespace tumble::course
