/// @file
/// The bodies of a world, and how to change them while it runs.
#pragma once

#include <tumble/change_log.hpp>
#include <tumble/marks.hpp>
#include <tumble/named_bodies.hpp>
#include <tumble/planner.hpp>

namespace tumble {

/// The part of a World that has bodies, but no effects and no time. Every function that could
/// change the plan tells the planner, so that the plan stays right.
template <class Real, class Keeping>
class SceneBodies {
 public:
  // --- Bodies -----------------------------------------------------------------------------------

  /// Adds a point, or a body, which should come from make_rigid_body() or make_static_body(): here
  /// each number is checked by itself, and not whether a body can have such moments.
  /// @throws std::invalid_argument if the name is empty or taken, if a number is not finite, if an
  /// inverse mass or moment is negative, if the orientation is not nearly of norm 1, or if there is
  /// angular momentum about a locked axis.
  BodyHandle add(const std::string& name, const Particle<Real>& point) {
    return came(name, bodies_.append(name, point, nullptr));
  }
  BodyHandle add(const std::string& name, const RigidBody<Real>& body) {
    return came(name, bodies_.append(name, body.centre, &body.top));
  }

  /// Removes a body, and the effects that are fixed to it.
  void remove(BodyHandle body) {
    const BodyIndex index = bodies_.index_of(body);
    change_log_.note("'" + name_of(body) + "' was removed");
    limit_changed_ |= planner_.is_limiting(index);
    marks_.forget_all();
    planner_.forget_body(body, bodies_);
    bodies_.remove(body);
    planner_.join_again(index, bodies_);
  }

  bool contains(BodyHandle body) const { return bodies_.contains(body); }
  std::size_t body_count() const { return bodies_.size(); }
  std::size_t top_count() const { return bodies_.top_count(); }
  /// @throws std::invalid_argument if no body has that name.
  BodyHandle find(const std::string& name) const { return bodies_.find(name); }
  const std::string& name_of(BodyHandle body) const {
    return bodies_.name_of(bodies_.index_of(body));
  }
  /// All bodies, in the order of the arrays.
  std::vector<BodyHandle> handles() const {
    std::vector<BodyHandle> all;
    for (BodyIndex index = 0; index < bodies_.size(); ++index)
      all.push_back(bodies_.handle_at(index));
    return all;
  }
  /// The body with that place in the arrays, and the place of a body.
  BodyHandle handle_at(BodyIndex index) const { return bodies_.handle_at(index); }
  BodyIndex index_of(BodyHandle body) const { return bodies_.index_of(body); }
  bool is_point(BodyHandle body) const { return bodies_.is_point(bodies_.index_of(body)); }

  /// The body as it is now; a point has a top that is locked about every axis.
  RigidBody<Real> body(BodyHandle body) const { return bodies_.body(bodies_.index_of(body)); }
  /// All of them: a reference to them, or, from a Keeping that has them in another form, a copy.
  decltype(auto) bodies() const { return bodies_.kept().bodies(); }
  /// How the bodies are kept, for instance to set the number of threads.
  Keeping& keeping() { return bodies_.kept(); }

  // --- Changes while it runs --------------------------------------------------------------------

  /// Puts another body in the place of one that is not a point: with another mass, say. It keeps
  /// its name and its effects.
  void replace(BodyHandle body, const RigidBody<Real>& by) {
    check_body(name_of(body), by.centre);
    check_body(name_of(body), by.top);
    require_top(body);
    change_log_.note("'" + name_of(body) + "' was replaced");
    limit_changed_ |= planner_.is_limiting(bodies_.index_of(body));
    RigidBody<Real> kept = by;
    kept.top.orientation = renormalized(by.top.orientation);
    bodies_.set(bodies_.index_of(body), kept);
    planner_.change_body(bodies_.index_of(body), bodies_);
  }

  void set_position(BodyHandle body, const Vec3<Same<Real>>& position) {
    require_finite(name_of(body) + ": position", position, "m");
    change_state(body, [&](RigidBody<Real>& changed) { changed.centre.position = position; });
  }

  void set_velocity(BodyHandle body, const Vec3<Same<Real>>& velocity) {
    require_finite(name_of(body) + ": velocity", velocity, "m/s");
    change_state(body, [&](RigidBody<Real>& changed) { changed.centre.velocity = velocity; });
  }

  void set_orientation(BodyHandle body, const Quaternion<Real>& orientation) {
    require_top(body);
    const Quaternion<Real> q = checked_orientation(orientation, name_of(body) + ": orientation");
    change_state(body, [&](RigidBody<Real>& changed) { changed.top.orientation = q; });
  }

  /// Sets the angular velocity, rad/s, world axes.
  void set_angular_velocity(BodyHandle body, const Vec3<Same<Real>>& angular_velocity) {
    require_top(body);
    change_state(body, [&](RigidBody<Real>& changed) {
      set_checked_angular_velocity(name_of(body), changed.top, angular_velocity);
    });
  }

  /// A blow of `impulse` N s at `point` m, world axes, between two steps.
  void apply_impulse_at(BodyHandle body, const Vec3<Same<Real>>& impulse,
                        const Vec3<Same<Real>>& point) {
    change_state(body, [&](RigidBody<Real>& changed) {
      tumble::apply_impulse_at(changed, impulse, point);
      require_finite(name_of(body) + ": velocity after the blow", changed.centre.velocity, "m/s");
      require_finite(name_of(body) + ": angular momentum after the blow",
                     changed.top.angular_momentum_body, "kg m^2/s");
    });
  }

  /// A force (N) at `point` (m), both in world axes, in the next step alone, such as a player's
  /// push. The forces of several calls add up.
  void push_at(BodyHandle body, const Vec3<Same<Real>>& force, const Vec3<Same<Real>>& point) {
    require_finite(name_of(body) + ": force", force, "N");
    require_finite(name_of(body) + ": point of the force", point, "m");
    const Vec3<Real> centre = bodies_.body(bodies_.index_of(body)).centre.position;
    planner_.add_input(bodies_.index_of(body), {force, torque_about<Real>(centre, point, force)},
                       bodies_);
  }

  /// What the steps go through, and what is known of each body.
  const Work<Real>& work() const { return planner_.work(); }
  const std::vector<BodyFlags>& flags() const { return planner_.flags(); }

 protected:
  explicit SceneBodies(Real time_step) : time_step_(time_step) {}

  Real time_step_;
  NamedBodies<Real, Keeping> bodies_;
  Planner<Real> planner_;
  ChangeLog change_log_;
  bool limit_changed_ = false;
  Marks<Real> marks_;

 private:
  BodyHandle came(const std::string& name, BodyHandle body) {
    change_log_.note("'" + name + "' came");
    marks_.forget_all();
    planner_.add_body(bodies_);
    limit_changed_ |= planner_.is_limiting(bodies_.index_of(body));
    return note_motion(body);
  }

  void require_top(BodyHandle body) const {
    if (is_point(body))
      throw std::invalid_argument("'" + name_of(body) + "' is a point: it has no orientation");
  }

  /// Lets `change` change a body. If it throws, nothing has changed.
  template <class Change>
  void change_state(BodyHandle body, const Change& change) {
    const BodyIndex index = bodies_.index_of(body);
    RigidBody<Real> changed = bodies_.body(index);
    change(changed);
    bodies_.set(index, changed);
    planner_.touch(index);
    note_motion(body);
  }

  /// A first velocity or spin changes what the scene calls for.
  BodyHandle note_motion(BodyHandle body) {
    const BodyIndex index = bodies_.index_of(body);
    const BodyFlags before = planner_.alone()[index], now = bodies_.flags_of(index, before);
    if (now.moves != before.moves)
      change_log_.note("'" + name_of(body) + "' got its first velocity");
    if (now.turns != before.turns) change_log_.note("'" + name_of(body) + "' got its first spin");
    if (now != before) planner_.change_body(index, bodies_);
    return body;
  }
};

}  // namespace tumble
