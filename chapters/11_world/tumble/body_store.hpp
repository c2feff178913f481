/// @file
/// What a world asks of the arrays in which its bodies lie, whatever their form.
#pragma once

#include <tumble/body_flags.hpp>
#include <tumble/body_registry.hpp>

namespace tumble {

/// The arrays of a world. They know places and no names.
template <class Real>
class BodyStore {
 public:
  virtual ~BodyStore() = default;
  virtual const BodyMap& map() const = 0;
  /// The body; a point has a top that is locked about every axis.
  virtual RigidBody<Real> body(BodyIndex body) const = 0;
  /// Of a point only the centre is kept.
  virtual void set_body(BodyIndex body, const RigidBody<Real>& state) = 0;
  /// Appends a body; `top` is null for a point.
  virtual void append(const Particle<Real>& centre, const Top<Real>* top) = 0;
  /// Takes a body out; the last one gets its place, and the last top that of its top.
  virtual void take_out(BodyIndex body) = 0;

 protected:
  BodyStore() = default;
  BodyStore(const BodyStore&) = default;
  BodyStore(BodyStore&&) noexcept = default;
  BodyStore& operator=(const BodyStore&) = default;
  BodyStore& operator=(BodyStore&&) noexcept = default;
};

/// The bodies of a world, by name, handle or place, for all that needs neither effects nor time.
template <class Real>
struct NamedBodies {
  const BodyRegistry& registry;
  const BodyStore<Real>& store;

  std::size_t size() const { return registry.size(); }
  std::size_t top_count() const { return store.map().body_of.size(); }
  BodyIndex index_of(BodyHandle body) const { return registry.index_of(body); }
  BodyIndex top_of(BodyIndex body) const { return store.map().top_of[body]; }
  BodyIndex body_of(BodyIndex top) const { return store.map().body_of[top]; }
  bool is_point(BodyIndex body) const { return top_of(body) == no_index; }
  RigidBody<Real> body(BodyIndex body) const { return store.body(body); }
  BodyFlags flags_of(BodyIndex body, const BodyFlags& before) const {
    const RigidBody<Real> state = store.body(body);
    return flags_alone<Real>({state.centre, state.top}, is_point(body), before);
  }
};

}  // namespace tumble
