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
  using Pass = PackedPass<Real, width>;
  PackedBodies<Real, width> bodies;
  PackedUndoBuffer<Real, width> undo;

  /// What a pass does to the packs of an array from `begin` to before `end`.
  template <class Array>
  bool act(const Work<Real>& work, const Pass& pass, Array& array, std::uint32_t begin,
           std::uint32_t end, const StepTime<Real>& step) {
    const StepTime<Real> moment = step_time_of(pass.substep, step);
    const Pack<Real, width> h = moment.time_step;
    switch (pass.act) {
      case Act::remember:
        for_each_whole(pass.group, begin, end, [&](std::uint32_t first, std::uint32_t last) {
          for (std::uint32_t pack = first; pack < last; ++pack) undo.remember(array, pack);
        });
        for_each_part(pass.group, begin, end,
                      [&](std::uint32_t pack, const auto&) { undo.remember(array, pack); });
        return false;
      case Act::kick:
        visit_packs(array, pass.group, begin, end, [h](auto& one) { kick_and_clear(one, h); });
        return false;
      case Act::guard:
        return any_diverged(array.packs(), pass.group, begin, end);
      case Act::effect:
        pass.effect->run_on_packs(bodies, work.effects[pass.entry].visits, pass.group, begin, end,
                                  moment);
        return false;
      default:
        move(work, pass, array, begin, end, moment);
        return false;
    }
  }

  void act_on_both(const Work<Real>& work, const Pass& pass, const StepTime<Real>& step) {
    if (pass.act == Act::inputs)
      for (const Input<Real>& input : work.inputs) {
        RigidBody<Real> body = body_at(bodies, input.body);
        add_push(body.centre, body.top, input.push);
        set_body_at(bodies, input.body, body);
      }
    else
      pass.effect->run_on_packs(bodies, work.effects[pass.entry].visits, pass.group, 0, no_index,
                                step_time_of(pass.substep, step));
  }

  /// The body that diverged. All are put back to where they were.
  std::optional<BodyIndex> rolled_back(const Work<Real>& work) {
    const std::optional<BodyIndex> diverged = first_diverged<Real>(bodies, work);
    work.movers.for_each([&](BodyIndex i) { undo.restore(bodies.centres, i); });
    for (const IndexSet* group : {&work.steady, &work.tumbling})
      group->for_each([&](BodyIndex i) { undo.restore(bodies.tops, i); });
    return diverged;
  }

 private:
  static void kick_and_clear(Particle<Pack<Real, width>>& centre, const Pack<Real, width>& h) {
    kick(centre, h);
    clear_force(centre);
  }
  static void kick_and_clear(Top<Pack<Real, width>>& top, const Pack<Real, width>& h) {
    kick(top, h);
    clear_torque(top);
  }

  void move(const Work<Real>&, const Pass& pass, PackedArray<Particle, Real, width>& centres,
            std::uint32_t begin, std::uint32_t end, const StepTime<Real>& moment) {
    visit_packs(centres, pass.group, begin, end,
                [h = Pack<Real, width>(moment.time_step)](auto& centre) { drift(centre, h); });
  }
  void move(const Work<Real>& work, const Pass& pass, PackedArray<Top, Real, width>& tops,
            std::uint32_t begin, std::uint32_t end, const StepTime<Real>& moment) {
    using Packed = Pack<Real, width>;
    const Packed h = moment.time_step;
    if (pass.act == Act::rotor)
      visit_packs(tops, pass.group, begin, end,
                  [h, act = pass.rotor_act,
                   H = work.effects[pass.entry]
                           .effect->rotor_momentum_body(time_of(pass.rotor_act, moment))
                           .template cast<Packed>()
                           .eval()](auto& top) { act_on<Packed>(top, act, H, h); });
    else if (pass.act == Act::turn_steadily)
      visit_packs(tops, pass.group, begin, end, [h](auto& top) { turn_steadily(top, h); });
    else
      pass.rule->turn_packs(tops, pass.group, begin, end, moment.time_step);
  }
};

}  // namespace tumble
