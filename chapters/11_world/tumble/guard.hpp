/// @file
/// What keeps a world finite: a step that leads to an infinite number or to NaN is taken back.
#pragma once

#include <optional>
#include <tumble/motion_record.hpp>
#include <tumble/step_plan.hpp>

namespace tumble {

/// The motion of all bodies that a step can move or turn, as it was before it.
template <class Real>
class UndoBuffer {
 public:
  void remember(const Bodies<Real>& bodies, const StepPlan<Real>& plan) {
    centres_.clear();
    tops_.clear();
    for (const BodyIndex i : plan.moving) centres_.push_back(motion_of(bodies.centres[i]));
    for (const BodyIndex i : plan.turning) tops_.push_back(motion_of(bodies.tops[i]));
  }

  /// Puts it back, and empties the sums.
  void restore(Bodies<Real>& bodies, const StepPlan<Real>& plan) const {
    auto centre = centres_.begin();
    for (const BodyIndex i : plan.moving) set_motion(bodies.centres[i], *centre++);
    auto top = tops_.begin();
    for (const BodyIndex i : plan.turning) set_motion(bodies.tops[i], *top++);
  }

 private:
  std::vector<CentreMotion<Real>> centres_;
  std::vector<TopMotion<Real>> tops_;
};

/// Whether position and velocity, or orientation and angular momentum, are finite; of packs, a
/// mask. Zero times a finite number is zero; times an infinite one or NaN it is NaN, which equals
/// nothing.
//! [is_finite]
template <class Real>
auto is_finite(const Particle<Real>& centre) {
  const Vec3<Real>&x = centre.position, &v = centre.velocity;
  return 0 * x[0] + 0 * x[1] + 0 * x[2] + 0 * v[0] + 0 * v[1] + 0 * v[2] == 0;
}

template <class Real>
auto is_finite(const Top<Real>& top) {
  const Quaternion<Real>& q = top.orientation;
  const Vec3<Real>&v = q.imaginary, &L = top.angular_momentum_body;
  return 0 * q.real + 0 * v[0] + 0 * v[1] + 0 * v[2] + 0 * L[0] + 0 * L[1] + 0 * L[2] == 0;
}
//! [is_finite]

/// The first body whose place or velocity is not finite, else the first whose top is not. `bodies`
/// is a Bodies or a PackedBodies. @return nothing if all are finite
template <class Real, class AnyBodies>
std::optional<BodyIndex> first_diverged(const AnyBodies& bodies, const StepPlan<Real>& plan) {
  BodyIndex diverged = no_index;
  for (const BodyIndex i : plan.moving)
    if (!is_finite(bodies.centres[i])) diverged = std::min(diverged, i);
  if (diverged != no_index) return diverged;
  for (const BodyIndex i : plan.turning)
    if (!is_finite(bodies.tops[i])) diverged = std::min(diverged, bodies.body_of[i]);
  return diverged == no_index ? std::nullopt : std::optional(diverged);
}

}  // namespace tumble
