/// @file
/// How the effects of a scene answer what its bodies do, all together.
#pragma once

#include <algorithm>
#include <limits>
#include <tumble/held_points.hpp>
#include <tumble/semi_implicit_euler.hpp>
#include <tumble/step_plan.hpp>
#include <vector>

namespace tumble {

/// The time step (s) up to which no small stretches or speeds can grow, and what limits it;
/// infinite if nothing does.
template <class Real>
struct StepLimit {
  Real time_step = std::numeric_limits<Real>::infinity();  ///< s
  std::size_t effect = 0;                                  ///< its place among the scene's
  BodyIndex body = 0;             ///< on which body, or which first one of two
  Real at_rest = time_step;       ///< the step that would be short enough if no body spun, s
  BodyIndex spinning = no_index;  ///< of the one or two bodies, which nutates the fastest, if any
  Real nutation_rate = 0;         ///< of that, rad/s
};

/// The part of its rotors' angular momentum at `time` (s) that can make a top nutate, kg m²/s, body
/// axes. A component counts only if the top can turn about both other axes.
template <class Real>
Vec3<Real> nutating_momentum(const StepPlan<Real>& plan, BodyIndex index, const Top<Real>& top,
                             Real time) {
  Vec3<Real> sum = Vec3<Real>::Zero();
  for (const std::size_t i : plan.in_phase[static_cast<std::size_t>(Phase::turn)])
    if (plan.effects[i].members.indices.contains(index))
      sum += plan.effects[i].effect->rotor_angular_momentum_body(time);
  const Vec3<Real>& J = top.inverse_moments;
  for (int axis = 0; axis < 3; ++axis)
    if (J[(axis + 1) % 3] == 0 || J[(axis + 2) % 3] == 0) sum[axis] = 0;
  return sum;
}

/// The responses of a scene's effects, as the bodies are now.
template <class Real>
class Responses {
 public:
  /// Rotors count with what they hold at `time` (s).
  Responses(const StepPlan<Real>& plan, const NamedBodies<Real>& all, Real time)
      : nutations_(all.size(), Real(0)) {
    const std::vector<EffectInstance<Real>>& instances = plan.effects;
    for (std::size_t i = 0; i < instances.size(); ++i) {
      const EffectTraits<Real>& traits = instances[i].effect->traits();
      if (!traits.has_response) continue;
      std::vector<BodyIndex> bodies;
      if (instances[i].everyone)
        for (BodyIndex body = 0; body < all.size(); ++body) bodies.push_back(body);
      for (const BodyHandle target : instances[i].targets) bodies.push_back(all.index_of(target));
      const std::size_t stride = traits.joins_two() ? 2 : 1;
      for (std::size_t k = 0; k < bodies.size(); k += stride) {
        RigidBody<Real> first = all.body(bodies[k]),
                        second = stride == 2 ? all.body(bodies[k + 1]) : first;
        const Response<Real> response =
            instances[i].effect->response({first.centre, first.top}, {second.centre, second.top});
        if (response.stiffness == 0 && response.damping == 0 &&
            response.force == Vec3<Real>::Zero() &&
            response.turning_stiffness == Mat3<Real>::Zero() &&
            response.turning_damping == Mat3<Real>::Zero())
          continue;
        holds_.push_back({i, bodies[k], ends_.size(), stride});
        const auto ends = static_cast<Real>(stride);
        const auto add_rotors = [&](Top<Real>& top, BodyIndex body) {
          top.angular_momentum_body += nutating_momentum(plan, all.top_of(body), top, time);
        };
        add_rotors(first.top, bodies[k]);
        hold(first, bodies[k], response, response.arm_first, response.force, ends);
        if (stride == 1) continue;
        add_rotors(second.top, bodies[k + 1]);
        hold(second, bodies[k + 1], response, response.arm_second, -response.force, ends);
      }
    }
    for (HeldTurns<Real>* turnings : {&stiff_, &damped_}) turnings->find_strengths(all);
  }

  /// The limit of a scheme that bears, at rest, a step `times` as long as Euler's. By it a body
  /// whose nutation turns by θ (rad) in a step yields yielding_at(θ) times as easily as at rest,
  /// and that is finite below `largest_angle`.
  template <class Yielding>
  StepLimit<Real> limit(Real times, Real largest_angle, const Yielding& yielding_at) const {
    std::vector<Real> yields(nutations_.size(), Real(1));
    const Found at_rest = limit_of_euler(yields);
    if (at_rest.hold == none) return {};
    StepLimit<Real> limit = limited_by(at_rest.hold, times * at_rest.time_step);
    limit.at_rest = limit.time_step;
    const Real fastest = *std::max_element(nutations_.begin(), nutations_.end());
    if (fastest == 0) return limit;
    // In a longer step the bodies yield more, and so it must be shorter: one is just short enough.
    // Rounded, no angle may come to the largest one, where a tangent changes its sign.
    Real below = 0,
         above = std::min(limit.at_rest,
                          (largest_angle - 8 * std::numeric_limits<Real>::epsilon()) / fastest);
    for (int n = 0; n < std::numeric_limits<Real>::digits; ++n) {
      const Real middle = (below + above) / 2;
      for (BodyIndex body = 0; body < yields.size(); ++body)
        yields[body] = yielding_at(middle * nutations_[body]);
      const Found found = limit_of_euler(yields);
      (middle < times * found.time_step ? below : above) = middle;
      limit = limited_by(found.hold, below);
    }
    limit.at_rest = times * at_rest.time_step;
    return limit;
  }

  bool is_damped() const { return is_damped_; }

 private:
  struct End {
    Real stiffness, damping, inverse_mass;  // the last one at the centre, and what the arm adds:
    Real by_arm;
    BodyIndex body;
  };
  struct Hold {
    std::size_t effect;
    BodyIndex body;
    std::size_t first_end, end_count;  // one or two
  };
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  struct Found {
    Real time_step = std::numeric_limits<Real>::infinity();
    std::size_t hold = none;
  };

  StepLimit<Real> limited_by(std::size_t hold, Real time_step) const {
    StepLimit<Real> limit{
        .time_step = time_step, .effect = holds_[hold].effect, .body = holds_[hold].body};
    for (std::size_t end = holds_[hold].first_end, n = 0; n < holds_[hold].end_count; ++end, ++n)
      if (const BodyIndex body = ends_[end].body; nutations_[body] > limit.nutation_rate)
        limit.spinning = body, limit.nutation_rate = nutations_[body];
    return limit;
  }

  /// `ends`: one, or two of a hold that joins two.
  void hold(const RigidBody<Real>& body, BodyIndex index, const Response<Real>& response,
            const Vec3<Real>& arm, const Vec3<Real>& force, Real ends) {
    const auto& q = body.top.orientation;
    const Vec3<Real> arm_body = rotate_back<Real>(q, arm);
    const Real by_arm = largest_inverse_mass_at<Real>(body, arm_body) - body.centre.inverse_mass;
    ends_.push_back(
        {response.stiffness, response.damping, body.centre.inverse_mass, by_arm, index});
    bool resists_turns = by_arm != 0 && (response.stiffness != 0 || response.damping != 0);
    const std::size_t last = holds_.size() - 1;
    if (const Real part = arm.norm() * force.norm(); part != 0) {
      stiff_.add(index, turning_stiffness<Real>(arm_body, rotate_back<Real>(q, force)), part, last);
      resists_turns = true;
    }
    for (const auto& [turnings, K] :
         {std::pair(&stiff_, &response.turning_stiffness), {&damped_, &response.turning_damping}}) {
      const Real part = ends * K->norm();
      if (part == 0) continue;  // of most effects, and to turn a matrix takes its time
      Mat3<Real> K_body;
      for (int axis = 0; axis < 3; ++axis)
        K_body.col(axis) =
            rotate_back<Real>(q, ends * (*K * rotate<Real>(q, Vec3<Real>::Unit(axis))));
      turnings->add(index, K_body, part, last);
      resists_turns = true;
    }
    is_damped_ |= response.damping != 0 || response.turning_damping != Mat3<Real>::Zero();
    if (resists_turns) nutations_[index] = nutation_rate(body.top);
  }

  /// The limit of semi-implicit Euler where each body yields to turns so many times as easily as at
  /// rest, and the hold that sets it.
  Found limit_of_euler(const std::vector<Real>& yields) const {
    Found limit;
    const auto [stiff, stiff_hold] = stiff_.largest(yields);
    const auto [damped, damped_hold] = damped_.largest(yields);
    const std::vector<Real> stiffness = row_sums(1, 1, 0, yields),
                            damping = row_sums(0, 0, 1, yields);
    const Real most = std::numeric_limits<Real>::max();  // in place of infinite and NaN
    const auto bounded = [most](Real value) { return value <= most ? value : most; };
    for (std::size_t i = 0; i < holds_.size(); ++i) {
      const Real largest = largest_stable_time_step<Real>(bounded(stiffness[i] + stiff),
                                                          bounded(damping[i] + damped), 1);
      if (largest < limit.time_step) limit = {largest, i};
    }
    if (limit.hold == none) return limit;
    // The most by which what resists turns pulls back in a step h, in units of inverse moments.
    const auto turning_pull = [stiff = stiff, damped = damped](Real h) {
      return h * stiff * h + 2 * h * damped;
    };
    const Real h = limit.time_step;
    if (is_damped_) {
      const std::vector<Real> together = row_sums(h, h, 2 * h, yields);
      std::size_t hardest = 0;
      for (std::size_t i = 1; i < together.size(); ++i)
        if (together[i] > together[hardest]) hardest = i;
      const Real pull = together[hardest] + turning_pull(h);
      if (pull > 4 * (1 + 64 * std::numeric_limits<Real>::epsilon()))  // by more than rounding
        limit = {h * 4 / pull, hardest};
    }
    if (turning_pull(limit.time_step) > 2)
      limit.hold = limit.time_step * stiff > 2 * damped ? stiff_hold : damped_hold;
    return limit;
  }

  /// √s (w_a Σ_a √s + w_b Σ_b √s) of each hold, for the strengths s = a k b + d c of its ends.
  std::vector<Real> row_sums(Real a, Real b, Real d, const std::vector<Real>& yields) const {
    std::vector<Real> roots, sums(yields.size(), Real(0)), result;
    for (const End& end : ends_) {
      roots.push_back(std::sqrt(a * end.stiffness * b + d * end.damping));
      sums[end.body] += roots.back();
    }
    std::size_t end = 0;
    for (const Hold& hold : holds_) {
      Real row = 0;
      for (const std::size_t last = end + hold.end_count; end != last; ++end) {
        const auto& [k, c, at_centre, by_arm, body] = ends_[end];
        row += roots[end] * (at_centre + yields[body] * by_arm) * sums[body];
      }
      result.push_back(row);
    }
    return result;
  }

  std::vector<Real> nutations_;  // by body, rad/s; 0 of one that nothing holds against turns
  std::vector<Hold> holds_;
  std::vector<End> ends_;  // of the first hold, one or two, then of the second, ...
  HeldTurns<Real> stiff_, damped_;
  bool is_damped_ = false;
};

}  // namespace tumble
