/// @file
/// From what a scene calls for to the passes that a step runs.
#pragma once

#include <tumble/handles.hpp>
#include <tumble/pass.hpp>
#include <tumble/plan.hpp>

namespace tumble {

/// An effect in the world's list, with the bodies that it is meant for.
template <class Real>
struct Entry {
  EffectHandle handle;
  std::shared_ptr<const AnyEffect<Real>> effect;
  bool everyone = true;
  std::vector<BodyHandle> targets = {};  ///< else these; for joins, first and second in turn
};

/// What has happened to a body so far, other than by effects.
struct History {
  bool has_moved = false;   ///< it was given a velocity
  bool has_turned = false;  ///< it was given a spin
};

/// The bodies that an effect is meant for, as indices.
//! [targets]
template <class Real>
std::vector<BodyIndex> targets_of(const Entry<Real>& entry, const Slots& slots,
                                  std::size_t body_count) {
  std::vector<BodyIndex> targets;
  if (entry.everyone)
    for (BodyIndex body = 0; body < body_count; ++body) targets.push_back(body);
  else
    for (const BodyHandle target : entry.targets) targets.push_back(slots.index_of(target));
  return targets;
}
//! [targets]

/// What a body is, whatever acts on it.
template <class Real>
Facts facts_alone(const BodyState<Real>& body, bool is_point, const History& history) {
  Facts facts;
  facts.is_static = is_static(body.centre);
  facts.is_point = is_point;
  facts.can_turn = body.top.inverse_moments != Vec3<Real>::Zero();
  facts.is_gyroscopic = is_gyroscopic(body.top);
  facts.moves = history.has_moved;
  facts.turns = facts.can_turn && history.has_turned;
  return facts;
}

/// Notes what an effect that visits a body does for it. @return true if that is news
template <class Real>
bool note(Facts& facts, const AnyEffect<Real>& effect) {
  const Facts before = facts;
  facts.is_pushed |= effect.traits().gives_force;
  facts.is_torqued |= effect.traits().gives_torque && !facts.is_point;
  facts.moves |= effect.traits().gives_motion && !facts.is_static;
  facts.turns |= effect.traits().gives_spin && facts.can_turn;
  return facts.is_pushed != before.is_pushed || facts.is_torqued != before.is_torqued ||
         facts.moves != before.moves || facts.turns != before.turns;
}

/// What is known of every body. One effect can call for another, as a first torque calls for the
/// Magnus force; so the list is gone through until it brings no news. It ends: a fact only ever
/// turns from false to true.
//! [facts_of_all]
template <class Real>
std::vector<Facts> facts_of_all(const Bodies<Real>& bodies, const std::vector<History>& histories,
                                const std::vector<Entry<Real>>& entries, const Slots& slots) {
  const std::size_t count = bodies.centres.size();
  std::vector<Facts> facts(count);
  for (BodyIndex body = 0; body < count; ++body)
    facts[body] = facts_alone(state_of(bodies, body), is_point(bodies, body), histories[body]);
  for (bool news = true; news;) {
    news = false;
    for (const Entry<Real>& entry : entries) {
      const std::vector<BodyIndex> targets = targets_of(entry, slots, count);
      const std::size_t stride = entry.effect->traits().joins_two ? 2 : 1;
      for (std::size_t i = 0; i < targets.size(); i += stride) {
        Facts &first = facts[targets[i]], &last = facts[targets[i + stride - 1]];
        const bool skipped = stride == 2 ? !entry.effect->why_skipped(first, last).empty()
                                         : !entry.effect->why_skipped(first).empty();
        if (skipped) continue;
        news |= note(first, *entry.effect);
        if (stride == 2) news |= note(last, *entry.effect);
      }
    }
  }
  return facts;
}
//! [facts_of_all]

/// One pass of a step.
template <class Real>
struct Pass {
  std::shared_ptr<const AnyEffect<Real>> effect;
  Group group;
};

/// Asks the effect's predicate for each of its targets, gathers those that need it, and writes the
/// row of the plan.
//! [planned_pass]
template <class Real>
Pass<Real> planned_pass(const Entry<Real>& entry, const Bodies<Real>& bodies, const Slots& slots,
                        const std::vector<Facts>& facts, PlanRow& row) {
  const AnyEffect<Real>& effect = *entry.effect;
  const std::vector<BodyIndex> targets = targets_of(entry, slots, bodies.centres.size());
  const std::size_t stride = effect.traits().joins_two ? 2 : 1;
  Pass<Real> pass{entry.effect, {}};
  Reasons reasons;
  for (std::size_t i = 0; i < targets.size(); i += stride) {
    const Facts &first = facts[targets[i]], &last = facts[targets[i + stride - 1]];
    const std::string_view why =
        stride == 2 ? effect.why_skipped(first, last) : effect.why_skipped(first);
    if (!why.empty()) {
      reasons.add(why);
      continue;
    }
    ++row.visited;
    for (std::size_t k = i; k < i + stride; ++k)
      pass.group.members.push_back(effect.traits().visits_tops ? bodies.top_of[targets[k]]
                                                               : targets[k]);
  }
  const std::size_t all = effect.traits().visits_tops ? bodies.tops.size() : bodies.centres.size();
  if (entry.everyone && pass.group.members.size() == all) pass.group = {true, {}};
  row.effect = effect.name();
  row.phase = effect.phase();
  row.of = targets.size() / stride;
  row.reads = effect.traits().reads;
  row.writes = effect.traits().writes;
  row.reason = reasons.sentence(stride == 2 ? "pair" : "body");
  return pass;
}
//! [planned_pass]

/// A plan with the passes that carry it out.
template <class Real>
struct Planned {
  Plan plan;
  std::vector<Pass<Real>> passes;
  std::vector<Facts> facts;
  std::vector<BodyIndex> movers;   ///< the bodies whose centres can move
  std::vector<BodyIndex> turners;  ///< the tops that can turn
};

/// Makes the plan for effects that are given in the order of a step.
//! [make_plan]
template <class Real>
Planned<Real> make_plan(const Bodies<Real>& bodies, const std::vector<History>& histories,
                        const std::vector<Entry<Real>>& entries, const Slots& slots) {
  Planned<Real> planned;
  planned.facts = facts_of_all(bodies, histories, entries, slots);
  for (const Entry<Real>& entry : entries) {
    PlanRow row;
    Pass<Real> pass = planned_pass(entry, bodies, slots, planned.facts, row);
    if (row.visited > 0) planned.passes.push_back(std::move(pass));
    planned.plan.rows.push_back(std::move(row));
  }
  for (BodyIndex body = 0; body < planned.facts.size(); ++body) {
    if (planned.facts[body].moves) planned.movers.push_back(body);
    if (planned.facts[body].turns) planned.turners.push_back(bodies.top_of[body]);
  }
  return planned;
}
//! [make_plan]

}  // namespace tumble
