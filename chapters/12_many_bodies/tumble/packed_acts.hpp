/// @file
/// What a step does to packs.
#pragma once

#include <optional>
#include <tumble/packed_undo_buffer.hpp>
#include <tumble/schedule.hpp>

namespace tumble {

/// Bodies in packs, with what they were before the step, and what the passes of a Schedule do to
/// them.
template <class Real, int width>
struct PackedActs {
  PackedBodies<Real, width> bodies;
  PackedUndoBuffer<Real, width> undo;

  /// What a pass does to the packs of an array from `begin` to before `end`.
  /// @return whether a member has diverged, if the pass is the guard
  template <class Array>
  bool act(const StepPlan<Real>& plan, const PackedPass<Real, width>& pass, Array& array,
           std::uint32_t begin, std::uint32_t end, const StepTime<Real>& step) {
    switch (pass.task) {
      case Task::remember:
        for_each_whole(pass.indices, begin, end, [&](std::uint32_t first, std::uint32_t last) {
          for (std::uint32_t pack = first; pack < last; ++pack) undo.remember(array, pack);
        });
        for_each_part(pass.indices, begin, end,
                      [&](std::uint32_t pack, const auto&) { undo.remember(array, pack); });
        return false;
      case Task::run:
        run(plan, pass, begin, end, step);
        return false;
      default:
        return any_diverged(array.packs(), pass.indices, begin, end);
    }
  }

  /// The same for a pass on centre and top together, or on pairs, or for the inputs.
  void run_on_both(const StepPlan<Real>& plan, const PackedPass<Real, width>& pass,
                   const StepTime<Real>& step) {
    if (pass.effect) return run(plan, pass, 0, no_index, step);
    for (const Input<Real>& input : plan.inputs) {
      RigidBody<Real> body = body_at(bodies, input.body);
      add_push(body.centre, body.top, input.push);
      set_body_at(bodies, input.body, body);
    }
  }

  /// The body that diverged. All are put back to where they were.
  std::optional<BodyIndex> roll_back(const StepPlan<Real>& plan) {
    const std::optional<BodyIndex> diverged = first_diverged<Real>(bodies, plan);
    for (const BodyIndex i : plan.moving) undo.restore(bodies.centres, i);
    for (const BodyIndex i : plan.turning) undo.restore(bodies.tops, i);
    return diverged;
  }

 private:
  void run(const StepPlan<Real>& plan, const PackedPass<Real, width>& pass, std::uint32_t begin,
           std::uint32_t end, const StepTime<Real>& step) {
    pass.effect->run_on_packs(bodies, instance_of(pass, plan).members, pass.indices, begin, end,
                              step_time_of(pass, step), pass.row.act);
  }
};

}  // namespace tumble
