/// @file
/// The order of the passes in each substep; scheme.hpp has that of the substeps. The step, and all
/// that explains, judges or measures it, go through this list, and no other has the order.
#pragma once

#include <iterator>
#include <tumble/motions.hpp>

namespace tumble {

/// What a pass is: an effect of the scene, the pushes of this step alone, a motion of the step's
/// own, or a rotor, which shares its angular momentum about the turning.
enum class PassKind { effect, input, motion, rotor };

/// In which substeps, and of which phase, passes of a kind are run.
struct OrderRow {
  SubstepKind in;                 ///< of which kind of substep it is a part
  PassKind kind;                  ///< effects, motions, rotors, or what a program pushed
  Phase phase;                    ///< of its effects or motions
  RotorAct act = RotorAct::join;  ///< of rotors
};

/// All rotors have joined before any of them turns a body, and after the turning all goes the other
/// way round, so that a drift back undoes a drift forth.
//! [step_order]
inline constexpr std::array<OrderRow, 12> step_order = {{
    {SubstepKind::kick, PassKind::effect, Phase::force},  // forces and torques are summed
    {SubstepKind::kick, PassKind::input, Phase::force},   // and the user's pushes
    {SubstepKind::kick, PassKind::effect, Phase::kick},   // accelerations, and what is set
    {SubstepKind::kick, PassKind::motion, Phase::kick},   // the sums change velocities and spins
    {SubstepKind::whole, PassKind::effect, Phase::impulse},
    {SubstepKind::whole, PassKind::effect, Phase::damping},
    {SubstepKind::drift, PassKind::rotor, Phase::turn, RotorAct::join},
    {SubstepKind::drift, PassKind::rotor, Phase::turn, RotorAct::turn_before},
    {SubstepKind::drift, PassKind::motion, Phase::drift},  // bodies move on, and turn
    {SubstepKind::drift, PassKind::rotor, Phase::turn, RotorAct::turn_after},
    {SubstepKind::drift, PassKind::rotor, Phase::turn, RotorAct::leave},
    {SubstepKind::end, PassKind::effect, Phase::drift},  // what puts bodies somewhere itself
}};
//! [step_order]

/// One thing that a step does to all bodies that call for it.
template <class Real>
struct Pass {
  OrderRow row = step_order[0];  ///< in which row it stands
  Substep<Real> substep = {};    ///< and of which substep it is a part
  std::size_t place = 0;         ///< in the plan's effects or motions, of a copied plan too
};

/// What runs in a pass, and on whom. The inputs have none.
template <class Real>
const EffectInstance<Real>& instance_of(const Pass<Real>& pass, const StepPlan<Real>& plan) {
  return (pass.row.kind == PassKind::motion ? plan.motions : plan.effects)[pass.place];
}

/// The passes of a step in its order, to be gone through with a range-for. It keeps none of them,
/// and what it is made from must outlive it.
template <class Real>
class Passes {
 public:
  /// Those that visit anybody.
  explicit Passes(const StepPlan<Real>& plan)
      : Passes(plan, plan.substeps, plan.in_phase, plan.motions_in_phase) {}
  /// For these substeps; `effects` and `motions` have the places of those that take part, by phase.
  Passes(const StepPlan<Real>& plan, const std::vector<Substep<Real>>& substeps,
         const EffectsByPhase& effects, const EffectsByPhase& motions)
      : plan_(plan), substeps_(substeps), effects_(effects), motions_(motions) {}

  class Iterator {
   public:
    explicit Iterator(const Passes& passes) : passes_(passes) { find(); }
    Pass<Real> operator*() const {
      const OrderRow& row = step_order[row_];
      const Substep<Real>& substep = passes_.substeps_[substep_];
      if (row.kind == PassKind::input) return {row, substep, 0};
      const bool backwards = row.kind == PassKind::rotor && row.act >= RotorAct::turn_after;
      const std::vector<std::size_t>& places = passes_.places_of(row);
      return {row, substep, places[backwards ? places.size() - 1 - n_ : n_]};
    }
    Iterator& operator++() {
      ++n_;
      find();
      return *this;
    }
    bool operator==(std::default_sentinel_t) const { return substep_ == passes_.substeps_.size(); }

   private:
    /// Goes to the next row and the next substep until there is a pass.
    void find() {
      for (; substep_ < passes_.substeps_.size(); ++substep_, row_ = 0)
        for (; row_ < step_order.size(); ++row_, n_ = 0)
          if (step_order[row_].in == passes_.substeps_[substep_].kind &&
              n_ < passes_.count_of(step_order[row_]))
            return;
    }

    const Passes& passes_;
    std::size_t substep_ = 0, row_ = 0, n_ = 0;
  };
  Iterator begin() const { return Iterator(*this); }
  static std::default_sentinel_t end() { return {}; }

 private:
  const std::vector<std::size_t>& places_of(const OrderRow& row) const {
    return (row.kind == PassKind::motion ? motions_ : effects_)[std::size_t(row.phase)];
  }
  std::size_t count_of(const OrderRow& row) const {
    return row.kind == PassKind::input ? !plan_.inputs.empty() : places_of(row).size();
  }

  const StepPlan<Real>& plan_;
  const std::vector<Substep<Real>>& substeps_;
  const EffectsByPhase &effects_, &motions_;
};

/// All passes, those that visit nobody too.
template <class Real>
std::vector<Pass<Real>> all_passes(const StepPlan<Real>& plan,
                                   const std::vector<Substep<Real>>& substeps) {
  const auto by_phase = [](const std::vector<EffectInstance<Real>>& instances) {
    EffectsByPhase all;
    for (std::size_t i = 0; i < instances.size(); ++i)
      all[static_cast<std::size_t>(instances[i].effect->phase())].push_back(i);
    return all;
  };
  const EffectsByPhase effects = by_phase(plan.effects), motions = by_phase(plan.motions);
  std::vector<Pass<Real>> all;
  for (const Pass<Real> pass : Passes(plan, substeps, effects, motions)) all.push_back(pass);
  return all;
}

/// When a pass happens in a step. Rotors act with what they hold at their end of the drift.
template <class Real>
StepTime<Real> step_time_of(const Pass<Real>& pass, const StepTime<Real>& step) {
  const StepTime<Real> at = step_time_of(pass.substep, step);
  return pass.row.kind == PassKind::rotor ? StepTime<Real>{time_of(pass.row.act, at), at.time_step}
                                          : at;
}

/// Adds the pushes of this step alone.
template <class Real>
void add(const std::vector<Input<Real>>& inputs, Bodies<Real>& bodies) {
  for (const Input<Real>& input : inputs) {
    Top<Real> none;
    const BodyIndex top = bodies.top_of[input.body];
    add_push(bodies.centres[input.body], top == no_index ? none : bodies.tops[top], input.push);
  }
}

/// Whom the plan lets a pass visit; the inputs name their bodies themselves.
template <class Real>
const Members& members_of(const Pass<Real>& pass, const StepPlan<Real>& plan) {
  static const Members nobody;
  return pass.row.kind == PassKind::input ? nobody : instance_of(pass, plan).members;
}

/// Runs a pass on these members, in plain arrays.
template <class Real>
void run(const Pass<Real>& pass, const StepPlan<Real>& plan, const Members& members,
         Bodies<Real>& bodies, const StepTime<Real>& step) {
  if (pass.row.kind == PassKind::input) return add(plan.inputs, bodies);
  instance_of(pass, plan).effect->run(bodies, members, step_time_of(pass, step), pass.row.act);
}

}  // namespace tumble
