/// @file
/// How a world keeps its bodies: particles in one array, tops in another, and no top for a body
/// that never turns.
#pragma once

#include <cstdint>
#include <tumble/rigid_body.hpp>
#include <vector>

namespace tumble {

/// The place of a body in the arrays of its world. It changes when other bodies are removed; what
/// stays the same is the BodyHandle.
using BodyIndex = std::uint32_t;

/// Stands for an array element that a body does not have.
constexpr BodyIndex no_index = static_cast<BodyIndex>(-1);

/// What an effect sees of one body. A point shows a top that can't turn and does not spin.
template <class Real>
struct BodyState {
  const Particle<Real>& centre;
  const Top<Real>& top;
};

/// Which top belongs to which body, in whatever arrays they lie.
//! [bodies]
struct BodyMap {
  std::vector<BodyIndex> top_of;   ///< where a body's top is; no_index for a point
  std::vector<BodyIndex> body_of;  ///< whose top it is
};

/// All bodies of a world.
template <class Real>
struct Bodies : BodyMap {
  std::vector<Particle<Real>> centres;  ///< one for each body
  std::vector<Top<Real>> tops;          ///< one for each body that is not a point
};
//! [bodies]

/// True when the body has no orientation: it has no top.
inline bool is_point(const BodyMap& map, BodyIndex body) {
  return map.top_of[body] == no_index;
}

/// What effects see of the body. It refers into `bodies`, which must last as long; so one that
/// would be gone at once, such as the copy that ManyBodies gives, is refused by the compiler.
template <class Real>
BodyState<Real> state_of(const Bodies<Real>& bodies, BodyIndex body) {
  static const Top<Real> none;
  const BodyIndex top = bodies.top_of[body];
  return {bodies.centres[body], top == no_index ? none : bodies.tops[top]};
}
/// @cond no declaration of its own
template <class Real>
BodyState<Real> state_of(Bodies<Real>&& bodies, BodyIndex body) = delete;
/// @endcond

/// Appends a body; `top` is null for a point. `bodies` is a Bodies, or like one. @return its index
template <class AnyBodies, class Real>
BodyIndex append(AnyBodies& bodies, const Particle<Real>& centre, const Top<Real>* top) {
  const auto body = static_cast<BodyIndex>(bodies.centres.size());
  bodies.centres.push_back(centre);
  bodies.top_of.push_back(top ? static_cast<BodyIndex>(bodies.tops.size()) : no_index);
  if (top) {
    bodies.tops.push_back(*top);
    bodies.body_of.push_back(body);
  }
  return body;
}

/// Takes an element out of an array; the last one gets its place.
template <class Element>
void swap_and_pop(std::vector<Element>& array, BodyIndex i) {
  array[i] = std::move(array.back());
  array.pop_back();
}

/// Takes a body out of a Bodies, or what is like one. The last body gets its place, and the last
/// top the place of its top.
template <class AnyBodies>
void take_out(AnyBodies& bodies, BodyIndex body) {
  if (const BodyIndex top = bodies.top_of[body]; top != no_index) {
    swap_and_pop(bodies.tops, top);
    swap_and_pop(bodies.body_of, top);
    if (top < bodies.tops.size()) bodies.top_of[bodies.body_of[top]] = top;
  }
  swap_and_pop(bodies.centres, body);
  swap_and_pop(bodies.top_of, body);
  if (body < bodies.centres.size() && bodies.top_of[body] != no_index)
    bodies.body_of[bodies.top_of[body]] = body;
}

}  // namespace tumble
