/// @file
/// Other libraries among the contestants, in double.
#pragma once

#include <peers/peers.hpp>
#include <support/contest.hpp>

namespace tumble::support {

/// The problem as the peers get it.
template <class Forces>
peers::TopProblem for_peers(const Problem<Topd, Forces>& problem, peers::Torque torque,
                            double weight_times_arm) {
  const auto& [q, v] = problem.start.orientation;
  const Vec3d& L = problem.start.angular_momentum_body;
  const Vec3d& i = problem.start.inverse_moments;
  return {.torque = torque,
          .weight_times_arm = weight_times_arm,
          .inverse_moments = {i[0], i[1], i[2]},
          .start = {q, v[0], v[1], v[2], L[0], L[1], L[2]},
          .seconds = problem.seconds};
}

/// A peer in a library, with the answer as a top.
inline Contestant<Topd> contestant(const std::string& library,
                                   const peers::Peer<peers::TopState>& peer, const Topd& start) {
  return {library + " " + peer.name, library, peer.chooses_steps, [=](double knob) {
            const auto [w, x, y, z, L0, L1, L2] = peer.run(knob);
            Topd top = start;
            top.orientation = {w, {x, y, z}};
            top.angular_momentum_body = {L0, L1, L2};
            return top;
          }};
}

/// All of them are measured in double, so other precisions get none.
template <class Body, class Forces>
void append_peers(std::vector<Contestant<Body>>&, const Problem<Body, Forces>&, ...) {}

template <class Forces>
void append_peers(std::vector<Contestant<Topd>>& list, const Problem<Topd, Forces>& problem,
                  peers::Torque torque, double weight_times_arm) {
  for (const peers::Library& library : peers::libraries())
    for (const auto& peer : library.on_top(for_peers(problem, torque, weight_times_arm)))
      list.push_back(contestant(library.name, peer, problem.start));
}

template <class Forces>
void append_peers(std::vector<Contestant<Particled>>& list,
                  const Problem<Particled, Forces>& problem, peers::Force force,
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

}  // namespace tumble::support
