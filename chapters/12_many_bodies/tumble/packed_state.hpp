/// @file
/// The state of bodies in packs, and what a step does to it.
#pragma once

#include <optional>
#include <tumble/packed_undo_buffer.hpp>
#include <tumble/schedule.hpp>

namespace tumble {

/// True if a member in the packs from `begin` to before `end` is no longer finite.
template <class Real, int width, class Packed>
bool any_diverged(const std::vector<Packed>& array, const PackedIndexSet<Real, width>& indices,
                  std::uint32_t begin, std::uint32_t end) {
  typename PackMask<Real, width>::Lanes diverged{};
  for_each_pack(indices, begin, end, [&](std::uint32_t pack, const auto& members) {
    diverged |= (members && !is_finite(array[pack])).lanes;
  });
  for (int lane = 0; lane < width; ++lane)
    if (diverged[lane]) return true;
  return false;
}

/// Bodies in packs, with what they were before the step, and what the passes of a Schedule do to
/// them.
template <class Real, int width>
struct PackedState {
  PackedBodies<Real, width> bodies;
  PackedUndoBuffer<Real, width> undo;

  /// Does the task of a pass for the packs of an array from `begin` to before `end`.
  /// @return whether a member has diverged, if the task is to guard
  template <class Array>
  bool run_task(const StepPlan<Real>& plan, const PackedPass<Real, width>& pass, Array& array,
                std::uint32_t begin, std::uint32_t end, const StepTime<Real>& step) {
    switch (pass.task) {
      case Task::remember:
        for_each_pack(pass.indices, begin, end,
                      [&](std::uint32_t pack, const auto&) { undo.remember(array, pack); });
        return false;
      case Task::run:
        run(plan, pass, begin, end, step);
        return false;
      case Task::guard:
        return any_diverged(array.packs(), pass.indices, begin, end);
    }
    return false;
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

  /// Puts all bodies back to where they were before the step.
  void restore(const StepPlan<Real>& plan) {
    for (const BodyIndex i : plan.moving) undo.restore(bodies.centres, i);
    for (const BodyIndex i : plan.turning) undo.restore(bodies.tops, i);
  }

 private:
  void run(const StepPlan<Real>& plan, const PackedPass<Real, width>& pass, std::uint32_t begin,
           std::uint32_t end, const StepTime<Real>& step) {
    pass.effect->run_on_packs(bodies, instance_of(pass, plan).members, pass.indices, begin, end,
                              step_time_of(pass, step), pass.row.act);
  }
};

}  // namespace tumble
