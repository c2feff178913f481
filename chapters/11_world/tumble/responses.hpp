/// @file
/// How the effects of a scene answer what its bodies do, all together.
#pragma once

#include <limits>
#include <tumble/held_points.hpp>
#include <tumble/semi_implicit_euler.hpp>
#include <tumble/work.hpp>
#include <vector>

namespace tumble {

/// The time step (s) up to which no small stretches or speeds can grow, and what limits it;
/// infinite if nothing does.
//! [step_limit]
template <class Real>
struct StepLimit {
  Real time_step = std::numeric_limits<Real>::infinity();
  std::size_t entry = 0;  ///< the effect: its place among the scene's
  BodyIndex body = 0;     ///< on which body, or which first one of two
};
//! [step_limit]

/// The responses of a scene's effects, as the bodies are now.
template <class Real>
class Responses {
 public:
  /// `roster` has the bodies and knows the place of a handle, see NamedBodies.
  template <class Roster>
  Responses(const std::vector<Entry<Real>>& entries, const Roster& roster)
      : body_count_(roster.size()) {
    for (std::size_t i = 0; i < entries.size(); ++i) {
      const EffectTraits<Real>& traits = entries[i].effect->traits();
      if (!traits.has_response) continue;
      std::vector<BodyIndex> bodies;
      if (entries[i].everyone)
        for (BodyIndex body = 0; body < body_count_; ++body) bodies.push_back(body);
      for (const BodyHandle target : entries[i].targets) bodies.push_back(roster.index_of(target));
      const std::size_t stride = traits.joins_two() ? 2 : 1;
      for (std::size_t k = 0; k < bodies.size(); k += stride) {
        const RigidBody<Real> first = roster.body(bodies[k]),
                              second = stride == 2 ? roster.body(bodies[k + 1]) : first;
        const Response<Real> response =
            entries[i].effect->response({first.centre, first.top}, {second.centre, second.top});
        if (response.stiffness == 0 && response.damping == 0 &&
            response.turning_stiffness == Mat3<Real>::Zero() &&
            response.turning_damping == Mat3<Real>::Zero())
          continue;
        holds_.push_back({i, bodies[k], stride});
        const auto ends = static_cast<Real>(stride);
        hold(first, bodies[k], response, response.arm_first, response.force, ends);
        if (stride == 2)
          hold(second, bodies[k + 1], response, response.arm_second, -response.force, ends);
      }
    }
    for (HeldTurns<Real>* turnings : {&stiff_, &damped_}) turnings->find_largest(roster);
  }

  /// See step_limit(). @return that of semi-implicit Euler
  StepLimit<Real> limit() const {
    StepLimit<Real> limit;
    const std::vector<Real> stiffness = rows(1, 1, 0), damping = rows(0, 0, 1);
    const Real most = std::numeric_limits<Real>::max();  // in place of infinite and NaN
    const auto bounded = [most](Real value) { return value <= most ? value : most; };
    for (std::size_t i = 0; i < holds_.size(); ++i) {
      const Real largest = largest_stable_time_step<Real>(bounded(stiffness[i] + stiff_.largest),
                                                          bounded(damping[i] + damped_.largest), 1);
      if (largest < limit.time_step) limit = limited_by(holds_[i], largest);
    }
    if (!std::isfinite(limit.time_step)) return limit;
    const Real h = limit.time_step;
    if (is_damped()) {
      const std::vector<Real> together = rows(h, h, 2 * h);
      std::size_t hardest = 0;
      for (std::size_t i = 1; i < together.size(); ++i)
        if (together[i] > together[hardest]) hardest = i;
      const Real pull = together[hardest] + turning_pull(h);
      if (pull > 4 * (1 + 64 * std::numeric_limits<Real>::epsilon()))  // by more than rounding
        limit = limited_by(holds_[hardest], h * 4 / pull);
    }
    if (!(turning_pull(limit.time_step) > 2)) return limit;
    const bool is_stiff = limit.time_step * stiff_.largest > 2 * damped_.largest;
    return limited_by(holds_[is_stiff ? stiff_.hold : damped_.hold], limit.time_step);
  }

  bool is_damped() const { return is_damped_ || damped_.largest != 0; }

 private:
  struct End {
    Real stiffness, damping, inverse_mass;
    BodyIndex body;
  };
  struct Hold {
    std::size_t entry;
    BodyIndex body;
    std::size_t end_count;  // one or two
  };
  static StepLimit<Real> limited_by(const Hold& hold, Real time_step) {
    return {time_step, hold.entry, hold.body};
  }

  /// `ends`: one, or two of a hold that joins two.
  void hold(const RigidBody<Real>& body, BodyIndex index, const Response<Real>& response,
            const Vec3<Real>& arm, const Vec3<Real>& force, Real ends) {
    const auto& q = body.top.orientation;
    const Vec3<Real> arm_body = rotate_back<Real>(q, arm);
    ends_.push_back({response.stiffness, response.damping,
                     largest_inverse_mass_at<Real>(body, arm_body), index});
    is_damped_ |= response.damping != 0;
    const std::size_t last = holds_.size() - 1;
    if (const Real part = arm.norm() * force.norm(); part != 0)
      stiff_.add(index, turning_stiffness<Real>(arm_body, rotate_back<Real>(q, force)), part, last);
    for (const auto& [turnings, K] :
         {std::pair(&stiff_, &response.turning_stiffness), {&damped_, &response.turning_damping}}) {
      const Real part = ends * K->norm();
      if (part == 0) continue;  // of most effects, and to turn a matrix takes its time
      const Mat3<Real> R = matrix_of(q);
      turnings->add(index, ends * (R.transpose() * *K * R), part, last);
    }
  }

  /// How hard what resists turns pulls back in a step, in units of the inverse moments, at most.
  Real turning_pull(Real h) const { return h * stiff_.largest * h + 2 * h * damped_.largest; }

  /// √s (w_a Σ_a √s + w_b Σ_b √s) of each hold, for the strengths s = a k b + d c of its ends.
  std::vector<Real> rows(Real a, Real b, Real d) const {
    std::vector<Real> roots, sums(body_count_, Real(0)), result;
    for (const End& end : ends_) {
      roots.push_back(std::sqrt(a * end.stiffness * b + d * end.damping));
      sums[end.body] += roots.back();
    }
    std::size_t end = 0;
    for (const Hold& hold : holds_) {
      Real row = 0;
      for (const std::size_t last = end + hold.end_count; end != last; ++end)
        row += roots[end] * ends_[end].inverse_mass * sums[ends_[end].body];
      result.push_back(row);
    }
    return result;
  }

  std::size_t body_count_;
  std::vector<Hold> holds_;
  std::vector<End> ends_;  // of the first hold, one or two, then of the second, ...
  HeldTurns<Real> stiff_, damped_;
  bool is_damped_ = false;
};

}  // namespace tumble
