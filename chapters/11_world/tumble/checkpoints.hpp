/// @file
/// How the bodies of a world move at one moment, to come back to it at the cost of those alone
/// that may have moved.
#pragma once

#include <memory>
#include <tumble/snapshot.hpp>

namespace tumble {

/// How one body moves, and what the plan knew of it. Of a point the top says nothing.
template <class Real>
struct BodyMotion {
  CentreMotion<Real> centre;
  TopMotion<Real> top;
  bool has_moved, has_turned;
};

/// The motion of all bodies after so many steps: a list of all that many checkpoints share, and
/// those that may have moved since it was made.
template <class Real>
struct Checkpoint : WorldTime<Real> {
  std::uint64_t arrangement = 0;                             ///< of the bodies, see Slots
  std::shared_ptr<const std::vector<BodyMotion<Real>>> all;  ///< in the order of the world
  std::vector<BodyIndex> moved;                              ///< in no order
  std::vector<BodyMotion<Real>> motions;                     ///< of these
};

/// Makes the checkpoints of a world and goes back to them. A body moves as it does in the list of
/// all unless it can move or turn now, or was touched since: by its user, or by a change of what
/// acts on it.
template <class Real>
class Checkpoints {
 public:
  /// A body comes or goes, or all are changed: the next checkpoint begins a new list of all.
  void forget_all() { all_.reset(); }

  /// How all bodies of the world move now, after so many steps.
  //! [make_checkpoint]
  Checkpoint<Real> make(const WorldTime<Real>& time, const NamedBodies<Real>& bodies,
                        Planner<Real>& planner) {
    Checkpoint<Real> now{time, bodies.registry.arrangement(), all_, {}, {}};
    if (all_) {
      now.moved = may_have_moved(bodies, planner);
      now.motions.reserve(now.moved.size());
      for (const BodyIndex body : now.moved)
        now.motions.push_back(motion_of(body, bodies, planner));
      return now;
    }
    std::vector<BodyMotion<Real>> all;
    for (BodyIndex body = 0; body < bodies.size(); ++body)
      all.push_back(motion_of(body, bodies, planner));
    now.all = all_ = std::make_shared<const std::vector<BodyMotion<Real>>>(std::move(all));
    planner.clear_touched();
    return now;
  }
  //! [make_checkpoint]

  /// Lets all bodies move as they did then.
  /// @throws std::invalid_argument if it is of another world, or a body has come or gone since.
  void restore(const Checkpoint<Real>& then, const NamedBodies<Real>& bodies,
               BodyStore<Real>& store, Planner<Real>& planner) {
    if (then.arrangement != bodies.registry.arrangement())
      throw std::invalid_argument(
          "the checkpoint is of another world, or a body has come or gone since; a copy of the "
          "world outlasts bodies that come and go");
    planner.end_inputs(bodies);
    std::vector<BodyIndex> others;
    if (all_ && then.all == all_) {
      others = may_have_moved(bodies, planner);
    } else {
      for (BodyIndex body = 0; body < bodies.size(); ++body) others.push_back(body);
      planner.clear_touched();
      all_ = then.all;
    }
    if (others != then.moved) {  // else nobody has moved who had not then
      IndexSet moved;
      for (const BodyIndex body : then.moved) moved.insert(body);
      for (const BodyIndex body : others)
        if (!moved.contains(body)) move_as(body, (*then.all)[body], bodies, store, planner);
    }
    for (std::size_t i = 0; i < then.moved.size(); ++i) {
      move_as(then.moved[i], then.motions[i], bodies, store, planner);
      planner.touch(then.moved[i]);
    }
  }

 private:
  /// Each once.
  static std::vector<BodyIndex> may_have_moved(const NamedBodies<Real>& bodies,
                                               const Planner<Real>& planner) {
    const StepPlan<Real>& plan = planner.step_plan();
    std::vector<BodyIndex> found;
    found.reserve(plan.moving.size());
    for (const BodyIndex body : plan.moving) found.push_back(body);
    for (const BodyIndex top : plan.turning) {
      const BodyIndex body = bodies.body_of(top);
      if (!plan.moving.contains(body)) found.push_back(body);
    }
    for (const BodyIndex body : planner.touched()) {
      const BodyIndex top = bodies.top_of(body);
      const bool turns = top != no_index && plan.turning.contains(top);
      if (!turns && !plan.moving.contains(body)) found.push_back(body);
    }
    return found;
  }

  static BodyMotion<Real> motion_of(BodyIndex index, const NamedBodies<Real>& bodies,
                                    const Planner<Real>& planner) {
    const RigidBody<Real> body = bodies.body(index);
    const BodyFlags& alone = planner.own_flags()[index];
    return {tumble::motion_of(body.centre), tumble::motion_of(body.top), alone.moves, alone.turns};
  }

  static void move_as(BodyIndex index, const BodyMotion<Real>& then,
                      const NamedBodies<Real>& bodies, BodyStore<Real>& store,
                      Planner<Real>& planner) {
    RigidBody<Real> body = bodies.body(index);
    set_motion(body.centre, then.centre);
    set_motion(body.top, then.top);
    store.set_body(index, body);
    planner.restore_flags(index, then.has_moved, then.has_turned, bodies);
  }

  std::shared_ptr<const std::vector<BodyMotion<Real>>>
      all_;  // none where checkpoints can't share one
};

}  // namespace tumble
