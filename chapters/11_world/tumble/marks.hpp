/// @file
/// How the bodies of a world move at one moment, to come back to it at the cost of those alone
/// that may have moved.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <tumble/work.hpp>
#include <unordered_set>
#include <vector>

namespace tumble {

/// Throws unless there are as many bodies and tops as `what` has.
template <class Roster>
void require_as_many(const std::string& what, std::size_t bodies, std::size_t tops,
                     const Roster& roster) {
  if (bodies == roster.size() && tops == roster.top_count()) return;
  throw std::invalid_argument("the " + what + " has " + std::to_string(bodies) + " bodies, " +
                              std::to_string(tops) + " of them with a top; the world has " +
                              std::to_string(roster.size()) + " and " +
                              std::to_string(roster.top_count()));
}

/// How one body moves, and what the plan knew of it. Of a point the orientation and the angular
/// momentum say nothing.
template <class Real>
struct BodyMotion {
  Vec3<Real> position, velocity;
  Quaternion<Real> orientation;
  Vec3<Real> angular_momentum_body;
  bool has_moved, has_turned;
};

/// The motion of all bodies after so many steps: a list of all that many marks share, and those
/// that may have moved since it was made.
template <class Real>
struct Mark {
  std::int64_t ticks = 0;
  std::size_t top_count = 0;
  std::shared_ptr<const std::vector<BodyMotion<Real>>> all;  ///< in the order of the world
  std::vector<BodyIndex> moved;                              ///< in no order
  std::vector<BodyMotion<Real>> motions;                     ///< of these
};

/// Makes the marks of a world and goes back to them. A body moves as it does in the list of all
/// unless it can move or turn now, or was touched since: by its user, or by a change of what acts
/// on it. `Roster` is a NamedBodies, and `AnyPlanner` a Planner.
template <class Real>
class Marks {
 public:
  /// A body comes or goes, or all are changed: the next mark begins a new list of all.
  void forget_all() { all_.reset(); }

  /// How all bodies of the world move now, after so many steps.
  //! [make_mark]
  template <class Roster, class AnyPlanner>
  Mark<Real> mark(std::int64_t ticks, const Roster& roster, AnyPlanner& planner) {
    Mark<Real> now{ticks, roster.top_count(), all_, {}, {}};
    if (all_) {
      now.moved = may_have_moved(roster, planner);
      now.motions.reserve(now.moved.size());
      for (const BodyIndex body : now.moved)
        now.motions.push_back(motion_of(body, roster, planner));
      return now;
    }
    std::vector<BodyMotion<Real>> all;
    for (BodyIndex body = 0; body < roster.size(); ++body)
      all.push_back(motion_of(body, roster, planner));
    now.all = all_ = std::make_shared<const std::vector<BodyMotion<Real>>>(std::move(all));
    planner.touched_by_nobody();
    return now;
  }
  //! [make_mark]

  /// Lets all bodies move as they did then.
  /// @throws std::invalid_argument if there are more bodies or tops than then, or fewer.
  template <class Roster, class AnyPlanner>
  void restore(const Mark<Real>& then, Roster& roster, AnyPlanner& planner) {
    require_as_many("mark", then.all ? then.all->size() : 0, then.top_count, roster);
    planner.end_inputs(roster);
    std::vector<BodyIndex> others;
    if (all_ && then.all == all_) {
      others = may_have_moved(roster, planner);
    } else {
      for (BodyIndex body = 0; body < roster.size(); ++body) others.push_back(body);
      planner.touched_by_nobody();
      all_ = then.all;
    }
    if (others != then.moved) {  // else nobody has moved who had not then
      const std::unordered_set<BodyIndex> moved(then.moved.begin(), then.moved.end());
      for (const BodyIndex body : others)
        if (!moved.contains(body)) move_as(body, (*then.all)[body], roster, planner);
    }
    for (std::size_t i = 0; i < then.moved.size(); ++i) {
      move_as(then.moved[i], then.motions[i], roster, planner);
      planner.touch(then.moved[i]);
    }
  }

 private:
  /// Each once.
  template <class Roster, class AnyPlanner>
  static std::vector<BodyIndex> may_have_moved(const Roster& roster, const AnyPlanner& planner) {
    const Work<Real>& work = planner.work();
    std::vector<BodyIndex> bodies;
    bodies.reserve(work.movers.size());
    work.movers.for_each([&](BodyIndex body) { bodies.push_back(body); });
    for (const IndexSet* group : {&work.steady, &work.tumbling})
      group->for_each([&](BodyIndex top) {
        const BodyIndex body = roster.body_of(top);
        if (!work.movers.contains(body)) bodies.push_back(body);
      });
    planner.touched().for_each([&](BodyIndex body) {
      const BodyIndex top = roster.top_of(body);
      const bool turns =
          top != no_index && (work.steady.contains(top) || work.tumbling.contains(top));
      if (!turns && !work.movers.contains(body)) bodies.push_back(body);
    });
    return bodies;
  }

  template <class Roster, class AnyPlanner>
  static BodyMotion<Real> motion_of(BodyIndex index, const Roster& roster,
                                    const AnyPlanner& planner) {
    const RigidBody<Real> body = roster.body(index);
    const BodyFlags& alone = planner.alone()[index];
    return {body.centre.position,           body.centre.velocity, body.top.orientation,
            body.top.angular_momentum_body, alone.moves,          alone.turns};
  }

  template <class Roster, class AnyPlanner>
  static void move_as(BodyIndex index, const BodyMotion<Real>& motion, Roster& roster,
                      AnyPlanner& planner) {
    RigidBody<Real> body = roster.body(index);
    body.centre.position = motion.position;
    body.centre.velocity = motion.velocity;
    body.top.orientation = motion.orientation;
    body.top.angular_momentum_body = motion.angular_momentum_body;
    roster.set(index, body);
    planner.restore_flags(index, motion.has_moved, motion.has_turned, roster);
  }

  std::shared_ptr<const std::vector<BodyMotion<Real>>> all_;  // none where marks can't share one
};

}  // namespace tumble
