/// @file
/// What keeps a world whole: a step that leads to a number that is no number is taken back.
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

/// What a step changes, as it was before.
template <class Real>
struct Before {
  std::vector<Vec3<Real>> positions, velocities, angular_momenta;
  std::vector<Quaternion<Real>> orientations;
};

template <class Real>
void remember(const Bodies<Real>& bodies, Before<Real>& before) {
  before.positions.resize(bodies.centres.size());
  before.velocities.resize(bodies.centres.size());
  before.angular_momenta.resize(bodies.tops.size());
  before.orientations.resize(bodies.tops.size());
  for (std::size_t i = 0; i < bodies.centres.size(); ++i) {
    before.positions[i] = bodies.centres[i].position;
    before.velocities[i] = bodies.centres[i].velocity;
  }
  for (std::size_t i = 0; i < bodies.tops.size(); ++i) {
    before.angular_momenta[i] = bodies.tops[i].angular_momentum_body;
    before.orientations[i] = bodies.tops[i].orientation;
  }
}

template <class Real>
void restore(Bodies<Real>& bodies, const Before<Real>& before) {
  for (std::size_t i = 0; i < bodies.centres.size(); ++i) {
    bodies.centres[i].position = before.positions[i];
    bodies.centres[i].velocity = before.velocities[i];
  }
  for (std::size_t i = 0; i < bodies.tops.size(); ++i) {
    bodies.tops[i].angular_momentum_body = before.angular_momenta[i];
    bodies.tops[i].orientation = before.orientations[i];
  }
}

/// True if the body is somewhere, or turned somehow: every number is finite. Zero times a finite
/// number is zero; times an infinite one or NaN it is NaN, which equals nothing.
//! [is_whole]
template <class Real>
auto is_whole(const Particle<Real>& centre) {
  const Vec3<Real>&x = centre.position, &v = centre.velocity;
  return 0 * x[0] + 0 * x[1] + 0 * x[2] + 0 * v[0] + 0 * v[1] + 0 * v[2] == 0;
}

template <class Real>
auto is_whole(const Top<Real>& top) {
  const Quaternion<Real>& q = top.orientation;
  const Vec3<Real>&v = q.imaginary, &L = top.angular_momentum_body;
  return 0 * q.real + 0 * v[0] + 0 * v[1] + 0 * v[2] + 0 * L[0] + 0 * L[1] + 0 * L[2] == 0;
}
//! [is_whole]

/// A body that a step has led nowhere, as it was before it drifted.
template <class Real>
struct Stopped {
  BodyIndex index;
  RigidBody<Real> body;
};

/// The first body that is no longer whole. @return nothing if all are
template <class Real>
std::optional<BodyIndex> first_lost(const Bodies<Real>& bodies, const Planned<Real>& planned) {
  for (const BodyIndex body : planned.movers)
    if (!is_whole(bodies.centres[body])) return body;
  for (const BodyIndex top : planned.turners)
    if (!is_whole(bodies.tops[top])) return bodies.body_of[top];
  return std::nullopt;
}

/// What no finite turn is found for, as the end of a sentence: the angle |ω| h (rad), and how far
/// sine_cosine() reaches.
template <class Real>
std::string turn_too_far(const Top<Real>& top, Same<Real> time_step) {
  const Vec3<Real> spin = angular_velocity_body(top);
  const Real angle = time_step * std::hypot(spin[0], spin[1], spin[2]);  // no square overflows
  return text_of(angle) + " rad in this step, and no finite orientation was found; at most " +
         text_of(2 * SineCosineConstants<Real>::limit) + " rad can be turned";
}

/// Who is to blame: the first effect, in the order of the scene, that gives the body a push with an
/// element that is infinite or NaN. @return null if each alone is finite
template <class Real>
const AnyEffect<Real>* culprit_for(BodyIndex body, const std::vector<Pass<Real>>& passes,
                                   const Bodies<Real>& bodies, Real time, Push<Real>& push) {
  for (const Pass<Real>& pass : passes) {
    const AnyEffect<Real>& effect = *pass.effect;
    const std::vector<BodyIndex>& members = pass.group.members;
    if (effect.traits().joins_two) {
      for (std::size_t i = 0; i < members.size(); i += 2) {
        if (members[i] != body && members[i + 1] != body) continue;
        const PairPush<Real> pair =
            effect.push_on(state_of(bodies, members[i]), state_of(bodies, members[i + 1]), time);
        push = members[i] == body ? Push<Real>{pair.force_on_first, pair.torque_on_first}
                                  : Push<Real>{-pair.force_on_first, pair.torque_on_second};
        if (!is_finite(push.force) || !is_finite(push.torque)) return &effect;
      }
    } else {
      const BodyIndex member = effect.traits().visits_tops ? bodies.top_of[body] : body;
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

/// The error for a body that was led nowhere. `bodies` are as they were before the step.
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
  } else if (!is_finite(Vec3<Real>(failed.centre.position + time_step * failed.centre.velocity))) {
    what += "with a velocity of " + text_of(failed.centre.velocity) +
            " m/s the step would lead to no finite position";
  } else {
    what += "it would turn by " + turn_too_far(failed.top, moment.time_step);
  }
  what += "; the world is as it was before this step";
  return {what, name, culprit ? culprit->name() : std::string(), static_cast<double>(moment.time)};
}

}  // namespace tumble
