/// @file
/// How all bodies of a world move at one moment, to come back to it.
#pragma once

#include <tumble/motion_record.hpp>
#include <tumble/planner.hpp>
#include <tumble/world_time.hpp>

namespace tumble {

/// The motion of all bodies after so many steps, by their places. What acts on them is not part of
/// it, nor are their names and handles.
template <class Real>
struct Snapshot : WorldTime<Real> {
  std::vector<CentreMotion<Real>> centres;  ///< of the bodies, in the order of the world
  std::vector<TopMotion<Real>> tops;        ///< of those that are no points, in the same order
  std::vector<bool> has_moved;              ///< which bodies the plan knew to move
  std::vector<bool> has_turned;             ///< and which to turn
};

/// How all bodies move now, and what the planner knows of whether they do.
template <class Real>
Snapshot<Real> snapshot_of(const NamedBodies<Real>& bodies, const Planner<Real>& planner,
                           const WorldTime<Real>& time) {
  Snapshot<Real> now{time, {}, {}, {}, {}};
  for (BodyIndex index = 0; index < bodies.size(); ++index) {
    const RigidBody<Real> body = bodies.body(index);
    now.centres.push_back(motion_of(body.centre));
    if (!bodies.is_point(index)) now.tops.push_back(motion_of(body.top));
    now.has_moved.push_back(planner.own_flags()[index].moves);
    now.has_turned.push_back(planner.own_flags()[index].turns);
  }
  return now;
}

/// Lets all bodies, which lie in `store`, move as they did then.
template <class Real>
void restore(const Snapshot<Real>& then, const NamedBodies<Real>& bodies, BodyStore<Real>& store,
             Planner<Real>& planner) {
  if (then.centres.size() != bodies.size() || then.tops.size() != bodies.top_count())
    throw std::invalid_argument(
        joined({"the snapshot has ", std::to_string(then.centres.size()), " bodies, ",
                std::to_string(then.tops.size()), " of them with a top; the world has ",
                std::to_string(bodies.size()), " and ", std::to_string(bodies.top_count()),
                "; a copy of the world outlasts bodies that come and go"}));
  planner.end_inputs(bodies);
  for (BodyIndex index = 0, top = 0; index < bodies.size(); ++index) {
    RigidBody<Real> body = bodies.body(index);
    set_motion(body.centre, then.centres[index]);
    if (!bodies.is_point(index)) set_motion(body.top, then.tops[top++]);
    store.set_body(index, body);
  }
  for (BodyIndex index = 0; index < bodies.size(); ++index)
    planner.restore_flags(index, then.has_moved[index], then.has_turned[index], bodies);
}

}  // namespace tumble
