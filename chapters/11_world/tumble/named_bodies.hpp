/// @file
/// The bodies of a world, with their names and handles.
#pragma once

#include <string>
#include <tumble/body_flags.hpp>
#include <tumble/handles.hpp>
#include <tumble/make_rigid_body.hpp>
#include <tumble/snapshot.hpp>
#include <unordered_map>

namespace tumble {

/// Throws unless a world can hold such a centre, or such a top. `name` is what the error calls it.
template <class Real>
void check_body(const std::string& name, const Particle<Real>& centre) {
  require_finite(name + ": position", centre.position, "m");
  require_finite(name + ": velocity", centre.velocity, "m/s");
  require_not_negative(name + ": inverse mass", centre.inverse_mass, "1/kg");
}
template <class Real>
void check_body(const std::string& name, const Top<Real>& top) {
  checked_orientation(top.orientation, name + ": orientation");
  require_finite(name + ": angular momentum", top.angular_momentum_body, "kg m^2/s");
  require_finite(name + ": inverse moments", top.inverse_moments, "1/(kg m^2)");
  if (top.inverse_moments.minCoeff() < 0)
    reject(name + ": inverse moments", top.inverse_moments, "1/(kg m^2)", "each must be 0 or more");
  if (free_part<Real>(top, top.angular_momentum_body) != top.angular_momentum_body)
    reject(name + ": angular momentum", top.angular_momentum_body, "kg m^2/s, body axes",
           "it must be 0 about a locked axis");
}

/// Bodies, where `Keeping` says how they lie in memory.
template <class Real, class Keeping>
class NamedBodies {
 public:
  std::size_t size() const { return names_.size(); }
  std::size_t top_count() const { return kept_.top_count(); }
  bool contains(BodyHandle body) const { return slots_.contains(body); }
  BodyIndex index_of(BodyHandle body) const { return slots_.index_of(body); }
  BodyHandle handle_at(BodyIndex index) const { return slots_.handle_of(index); }
  const std::string& name_of(BodyIndex index) const { return names_[index]; }
  std::uint64_t family() const { return slots_.family(); }

  /// @throws std::invalid_argument if no body has that name.
  BodyHandle find(const std::string& name) const {
    const auto found = handles_.find(name);
    if (found == handles_.end()) throw std::invalid_argument("no body is called '" + name + "'");
    return found->second;
  }

  BodyIndex top_of(BodyIndex body) const { return kept_.top_of(body); }
  BodyIndex body_of(BodyIndex top) const { return kept_.body_of(top); }
  BodyIndex last_top() const { return static_cast<BodyIndex>(kept_.top_count() - 1); }
  bool is_point(BodyIndex body) const { return top_of(body) == no_index; }
  RigidBody<Real> body(BodyIndex body) const { return kept_.body(body); }
  BodyFlags flags_of(BodyIndex index, const BodyFlags& before) const {
    const RigidBody<Real> state = kept_.body(index);
    return flags_alone<Real>({state.centre, state.top}, is_point(index), before);
  }

  /// Appends a body whose sums are empty and whose orientation has norm 1; `top` is null for a
  /// point.
  BodyHandle append(const std::string& name, Particle<Real> centre, const Top<Real>* top) {
    if (name.empty()) throw std::invalid_argument("a body needs a name");
    if (handles_.contains(name))
      throw std::invalid_argument("two bodies are called '" + name + "'; names must differ");
    check_body(name, centre);
    if (top) check_body(name, *top);
    Top<Real> kept_top = top ? *top : Top<Real>{};
    kept_top.orientation = renormalized(kept_top.orientation);
    clear_force(centre);
    clear_torque(kept_top);
    const BodyHandle handle = slots_.take(kept_.append(centre, top ? &kept_top : nullptr));
    names_.push_back(name);
    handles_.emplace(name, handle);
    return handle;
  }

  /// Takes a body out; the last one gets its place.
  void remove(BodyHandle body) {
    const BodyIndex index = slots_.index_of(body);
    handles_.erase(names_[index]);
    kept_.take_out(index);
    slots_.release(body);
    replace_by_last(names_, index);
  }

  /// How all bodies move now, and what the plan knows of whether they do.
  Snapshot<Real> snapshot(std::int64_t ticks, const std::vector<BodyFlags>& alone) const {
    Snapshot<Real> now;
    now.ticks = ticks;
    for (BodyIndex index = 0; index < size(); ++index) {
      const RigidBody<Real> body = kept_.body(index);
      now.positions.push_back(body.centre.position);
      now.velocities.push_back(body.centre.velocity);
      now.has_moved.push_back(alone[index].moves);
      now.has_turned.push_back(alone[index].turns);
      if (is_point(index)) continue;
      now.orientations.push_back(body.top.orientation);
      now.angular_momenta.push_back(body.top.angular_momentum_body);
    }
    return now;
  }

  /// Lets all bodies move as they did then.
  void restore(const Snapshot<Real>& then) {
    std::size_t top = 0;
    for (BodyIndex index = 0; index < size(); ++index) {
      RigidBody<Real> body = kept_.body(index);
      body.centre.position = then.positions[index];
      body.centre.velocity = then.velocities[index];
      if (!is_point(index)) {
        body.top.orientation = then.orientations[top];
        body.top.angular_momentum_body = then.angular_momenta[top++];
      }
      set(index, body);
    }
  }

  /// Replaces the body's state. Its sums stay empty.
  void set(BodyIndex index, RigidBody<Real> body) {
    clear_forces(body);
    kept_.set_body(index, body);
  }

  Keeping& kept() { return kept_; }
  const Keeping& kept() const { return kept_; }

 private:
  Keeping kept_;
  std::vector<std::string> names_;  // in the order of the bodies
  std::unordered_map<std::string, BodyHandle> handles_;
  Slots slots_;
};

}  // namespace tumble
