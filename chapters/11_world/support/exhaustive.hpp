/// @file
/// A world stepped by its plan beside the same world stepped exhaustively.
#pragma once

#include <string>
#include <tumble/world.hpp>

namespace tumble::support {

struct Difference {
  BodyIndex body = no_index;
  std::string what;  ///< empty if there is none
};

/// Where two sets of bodies first differ in the value of a number of their motion. A zero may
/// differ in its sign, as 0 + v and v do.
template <class Real>
Difference first_difference(const Bodies<Real>& plan, const Bodies<Real>& other) {
  const auto said = [](BodyIndex body, const char* what) { return Difference{body, what}; };
  for (BodyIndex i = 0; i < plan.centres.size(); ++i) {
    if (plan.centres[i].position != other.centres[i].position) return said(i, "position");
    if (plan.centres[i].velocity != other.centres[i].velocity) return said(i, "velocity");
  }
  for (BodyIndex i = 0; i < plan.tops.size(); ++i) {
    const Top<Real>&a = plan.tops[i], &b = other.tops[i];
    if (a.angular_momentum_body != b.angular_momentum_body)
      return said(plan.body_of[i], "angular momentum");
    if (a.orientation.real != b.orientation.real ||
        a.orientation.imaginary != b.orientation.imaginary)
      return said(plan.body_of[i], "orientation");
  }
  return {};
}

/// The same as a sentence; empty if there is none.
template <class Real>
std::string difference_in_value(const Bodies<Real>& plan, const Bodies<Real>& other) {
  const Difference difference = first_difference(plan, other);
  if (difference.what.empty()) return {};
  return "body " + std::to_string(difference.body) + " differs in its " + difference.what;
}

/// Gives each top an orientation that the world's rule leaves as it is when the top does not spin.
/// For most rules that is any orientation; splitting without a sine rounds. The plan does not turn
/// a top that can't turn, so without this the two runs would differ by roundings that are no
/// motion.
template <class Real, class Backend>
void settle(World<Real, Backend>& world) {
  Members one;
  one.indices.insert(0);
  Bodies<Real> alone;
  for (BodyIndex body = 0; body < world.body_count(); ++body) {
    const BodyHandle handle = world.handle_at(body);
    if (world.is_point(handle)) continue;
    alone.tops = {world.body(handle).top};
    Top<Real>& top = alone.tops[0];
    const Vec3<Real> start = top.orientation.imaginary;
    for (int round = 1; round <= 1000; ++round) {
      top.angular_momentum_body.setZero();
      const Quaternion<Real> before = top.orientation;
      tumbling_of(world.step_plan()).effect->run(alone, one, world.step_time(), {});
      if (before.real == top.orientation.real && before.imaginary == top.orientation.imaginary)
        break;
      if (round % 10 == 0)  // it goes in a circle: from somewhere else
        top.orientation =
            quaternion_of_rotation_vector<Real>(Vec3<Real>::Constant(1 / Real(round))) * before;
    }
    if (top.orientation.imaginary != start) world.set_orientation(handle, top.orientation);
  }
}

}  // namespace tumble::support
