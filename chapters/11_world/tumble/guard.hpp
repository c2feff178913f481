/// @file
/// What keeps a world whole: a step that would leave a number that is no number is taken back.
#pragma once

#include <optional>
#include <stdexcept>
#include <tumble/planner.hpp>
#include <tumble/sine_cosine.hpp>

namespace tumble {

/// A step could not be taken. The world is as it was before.
class SimulationError : public std::runtime_error {
 public:
  SimulationError(const std::string& sentence, std::string body_name, std::string effect_name,
                  double at_time)
      : std::runtime_error(sentence),
        body(std::move(body_name)),
        effect(std::move(effect_name)),
        time(at_time) {}
  std::string body;    ///< whose motion could not be computed
  std::string effect;  ///< which effect is to blame; empty if it is none alone
  double time;         ///< s, at the start of the step
};

/// The momenta as they were before the kick.
template <class Real>
struct Momenta {
  std::vector<Vec3<Real>> velocities;
  std::vector<Vec3<Real>> angular_momenta;
};

template <class Real>
void remember(const Bodies<Real>& bodies, Momenta<Real>& before) {
  before.velocities.resize(bodies.centres.size());
  before.angular_momenta.resize(bodies.tops.size());
  for (std::size_t i = 0; i < bodies.centres.size(); ++i)
    before.velocities[i] = bodies.centres[i].velocity;
  for (std::size_t i = 0; i < bodies.tops.size(); ++i)
    before.angular_momenta[i] = bodies.tops[i].angular_momentum_body;
}

template <class Real>
void restore(Bodies<Real>& bodies, const Momenta<Real>& before) {
  for (std::size_t i = 0; i < bodies.centres.size(); ++i)
    bodies.centres[i].velocity = before.velocities[i];
  for (std::size_t i = 0; i < bodies.tops.size(); ++i)
    bodies.tops[i].angular_momentum_body = before.angular_momenta[i];
}

/// A bound of all angles (rad) that a rule of chapter 8 turns the top by in `time_step` seconds:
/// the sphere's part, a |L| h, and those of the other two axes. |ω| h is no larger than their sum.
//! [largest_turn]
template <class Real>
Real largest_turn(const Top<Real>& top, Same<Real> time_step) {
  using std::abs;
  const Vec3<Real>& i = top.inverse_moments;
  const Vec3<Real>& L = top.angular_momentum_body;
  return time_step *
         ((i[0] * L).norm() + abs(i[1] - i[0]) * abs(L[1]) + abs(i[2] - i[0]) * abs(L[2]));
}
//! [largest_turn]

/// True if the drift can be taken: the place it leads to is a place, and the turn an angle that
/// sine_cosine() knows.
//! [can_drift]
template <class Real>
auto can_drift(const Particle<Real>& centre, Same<Real> time_step) {
  using std::abs;
  const Vec3<Real> there = centre.position + time_step * centre.velocity;
  const Real largest = std::numeric_limits<Real>::max();
  return abs(there.x()) <= largest && abs(there.y()) <= largest && abs(there.z()) <= largest;
}

template <class Real>
auto can_drift(const Top<Real>& top, Same<Real> time_step) {
  return largest_turn(top, time_step) <= 2 * SineCosineConstants<Real>::limit;
}
//! [can_drift]

/// A body that could not drift, as the kick had left it.
template <class Real>
struct Stopped {
  BodyIndex index;
  RigidBody<Real> body;
};

/// The first body that can't drift. @return nothing if all can
template <class Real>
std::optional<BodyIndex> first_stopped(const Bodies<Real>& bodies, const Planned<Real>& planned,
                                       Real time_step) {
  for (const BodyIndex body : planned.movers)
    if (!can_drift(bodies.centres[body], time_step)) return body;
  for (const BodyIndex top : planned.turners)
    if (!can_drift(bodies.tops[top], time_step)) return bodies.body_of[top];
  return std::nullopt;
}

/// Who is to blame: the first effect, in the order of the scene, that gives the body a push with an
/// element that is infinite or NaN. @return null if each alone is finite
template <class Real>
const AnyEffect<Real>* culprit_for(BodyIndex body, const std::vector<Pass<Real>>& passes,
                                   const Bodies<Real>& bodies, Real time, Push<Real>& push) {
  for (const Pass<Real>& pass : passes) {
    const AnyEffect<Real>& effect = *pass.effect;
    const std::vector<BodyIndex>& members = pass.group.members;
    if (effect.joins_two()) {
      for (std::size_t i = 0; i < members.size(); i += 2) {
        if (members[i] != body && members[i + 1] != body) continue;
        const PairPush<Real> pair =
            effect.push_on(state_of(bodies, members[i]), state_of(bodies, members[i + 1]), time);
        push = members[i] == body ? Push<Real>{pair.force_on_first, pair.torque_on_first}
                                  : Push<Real>{-pair.force_on_first, pair.torque_on_second};
        if (!is_finite(push.force) || !is_finite(push.torque)) return &effect;
      }
    } else {
      const BodyIndex member = effect.visits_tops() ? bodies.top_of[body] : body;
      const bool is_one = pass.group.everyone
                              ? member != no_index
                              : std::find(members.begin(), members.end(), member) != members.end();
      if (!is_one) continue;
      push = effect.push_on(state_of(bodies, body), time);
      if (!is_finite(push.force) || !is_finite(push.torque)) return &effect;
    }
  }
  return nullptr;
}

/// The error for a body that could not drift. `bodies` are as they were before the step.
template <class Real>
SimulationError failure(const std::string& name, const Stopped<Real>& stopped,
                        const std::vector<Pass<Real>>& passes, const Bodies<Real>& bodies,
                        std::int64_t tick, Real time_step) {
  const RigidBody<Real>& failed = stopped.body;
  const Moment<Real> moment = moment_of(tick, time_step);
  Push<Real> push;
  const AnyEffect<Real>* culprit = culprit_for(stopped.index, passes, bodies, moment.time, push);
  std::string what =
      "'" + name + "' at " + text_of(moment.time) + " s (step " + std::to_string(tick) + "): ";
  if (culprit) {
    const bool force = !is_finite(push.force);
    what += culprit->name() + " gives a " + (force ? "force of " : "torque of ") +
            text_of(force ? push.force : push.torque) + (force ? " N" : " N m") +
            "; every component must be finite";
  } else if (!can_drift(failed.centre, moment.time_step)) {
    what += "with a velocity of " + text_of(failed.centre.velocity) +
            " m/s the step would lead to no finite position";
  } else {
    what += "it would turn by up to " + text_of(largest_turn(failed.top, moment.time_step)) +
            " rad in this step; at most " + text_of(2 * SineCosineConstants<Real>::limit) +
            " rad can be turned";
  }
  what += "; the world is as it was before this step";
  return {what, name, culprit ? culprit->name() : std::string(), static_cast<double>(moment.time)};
}

}  // namespace tumble
