/// @file
/// The books of a world: what each effect put in and took out, and what remains unexplained.
#pragma once

#include <cstdio>
#include <tumble/ledger_line.hpp>
#include <tumble/world.hpp>

namespace tumble {

/// The books. They are kept beside the world and never touch it: a step with books is the same to
/// the bit as one without. They take the step on a copy first, one effect after another.
template <class Real>
class Ledger {
 public:
  template <class Backend>
  explicit Ledger(const World<Real, Backend>& world) : start_(holdings_of(world.bodies())) {}

  /// One step of the world, booked. If it fails, nothing is booked.
  template <class Backend>
  void step(World<Real, Backend>& world) {
    Lines lines = lines_;
    book_step(world.bodies(), world.work(), world.step_time(), lines);
    world.step();
    lines_ = std::move(lines);
  }

  /// What the bodies had when the books were opened.
  const LedgerLine& start() const { return start_; }

  /// What they have now.
  template <class Backend>
  LedgerLine now(const World<Real, Backend>& world) const {
    return holdings_of(world.bodies());
  }

  /// What each effect put in so far.
  const std::vector<LedgerLine>& lines() const { return lines_; }

  /// What is neither start nor any line: rounding, if the books are right and nobody has changed a
  /// body or stepped the world beside them.
  template <class Backend>
  LedgerLine rest(const World<Real, Backend>& world) const {
    LedgerLine rest = now(world);
    rest -= start_;
    for (const LedgerLine& line : lines_) rest -= line;
    return rest;
  }

  /// The energy (J) stored in the effects that know theirs: gravity and springs.
  template <class Backend>
  static double stored(const World<Real, Backend>& world) {
    const Bodies<Real>& bodies = world.bodies();
    double sum = 0;
    for (const Entry<Real>& entry : world.effects()) {
      if (!entry.effect->traits().stores_energy) continue;
      const auto add = [&](BodyIndex first, BodyIndex second) {
        sum += static_cast<double>(
            entry.effect->potential_energy(state_of(bodies, first), state_of(bodies, second)));
      };
      entry.visits.group.for_each([&](BodyIndex i) {
        const BodyIndex body = entry.effect->traits().visits_tops() ? bodies.body_of[i] : i;
        add(body, body);
      });
      for (const BodyPair& pair : entry.visits.pairs) add(pair.first, pair.second);
    }
    return sum;
  }

 private:
  using Lines = std::vector<LedgerLine>;

  static LedgerLine& line_of(Lines& lines, const std::string& name) {
    for (LedgerLine& line : lines)
      if (line.name == name) return line;
    lines.push_back({name, 0, Vec3d::Zero(), Vec3d::Zero()});
    return lines.back();
  }

  /// The step on a copy. What changes momenta or places at once is booked as the difference that it
  /// makes; forces and torques, which act together, each by its share of the kick, see work_of().
  //! [book_step]
  static void book_step(Bodies<Real> bodies, const Work<Real>& work, const StepTime<Real>& moment,
                        Lines& lines) {
    const auto book = [&](const std::string& name, const auto& change) {
      const LedgerLine had = holdings_of(bodies);
      change();
      LedgerLine gained = holdings_of(bodies);
      line_of(lines, name) += gained -= had;
    };
    const auto book_phase = [&](Phase phase, const StepTime<Real>& at) {
      for (const std::size_t i : work.in_phase[static_cast<std::size_t>(phase)]) {
        const Entry<Real>& entry = work.effects[i];
        book(entry.effect->name(), [&] { entry.effect->run(bodies, entry.visits, at); });
      }
    };
    for (const std::size_t i : work.in_phase[static_cast<std::size_t>(Phase::force)])
      line_of(lines, work.effects[i].effect->name());  // lines stand in the order of the scene
    for (const Substep<Real>& substep : work.substeps) {
      const StepTime<Real> part = step_time_of(substep, moment);
      const Real h = part.time_step;
      if (substep.kind == SubstepKind::kick) {
        Bodies<Real> alone = bodies;  // for one force at a time
        for (const std::size_t i : work.in_phase[static_cast<std::size_t>(Phase::force)]) {
          const Entry<Real>& entry = work.effects[i];
          const auto act = [&] { entry.effect->run(bodies, entry.visits, part); };
          if (entry.effect->traits().writes.has_any(quantity::force | quantity::torque))
            act();
          else  // it changes momenta or places at once
            book(entry.effect->name(), act);
        }
        add(work.inputs, bodies);
        book_phase(Phase::kick, part);
        const Bodies<Real> summed = bodies;
        for_each_of(work.pushed, bodies.centres, [&](auto& centre) { kick(centre, h); });
        for_each_of(work.torqued, bodies.tops, [&](auto& top) { kick(top, h); });
        for (const std::size_t i : work.in_phase[static_cast<std::size_t>(Phase::force)]) {
          work.effects[i].effect->run(alone, work.effects[i].visits, part);
          book_kick(alone, summed, bodies, h, line_of(lines, work.effects[i].effect->name()));
        }
        add(work.inputs, alone);
        if (!work.inputs.empty()) book_kick(alone, summed, bodies, h, line_of(lines, "input"));
        for_each_of(work.pushed, bodies.centres, [](auto& centre) { clear_force(centre); });
        for_each_of(work.torqued, bodies.tops, [](auto& top) { clear_torque(top); });
      } else if (substep.kind == SubstepKind::whole) {
        book_phase(Phase::impulse, moment);
        book_phase(Phase::damping, moment);
      } else {
        if (!work.movers.empty())
          book("drift", [&] {
            for_each_of(work.movers, bodies.centres, [&](auto& centre) { drift(centre, h); });
          });
        const auto rotor = [&](std::size_t i, RotorAct act) {
          book(work.effects[i].effect->name(), [&] { run_rotor(work, i, act, bodies.tops, part); });
        };
        with_rotors(rotors_of(work), rotor, [&] {
          if (!work.steady.empty())
            book("steady turning", [&] {
              for_each_of(work.steady, bodies.tops, [&](auto& top) { turn_steadily(top, h); });
            });
          if (!work.tumbling.empty())
            book("tumbling: " + work.rule->name(),
                 [&] { work.rule->turn(bodies.tops, work.tumbling, h); });
        });
      }
    }
    book_phase(Phase::drift, moment);
  }
  //! [book_step]

  /// Books the sums that an effect alone has made, and empties them.
  static void book_kick(Bodies<Real>& alone, const Bodies<Real>& before, const Bodies<Real>& kicked,
                        Real h, LedgerLine& line) {
    for (BodyIndex body = 0; body < alone.centres.size(); ++body) {
      const BodyState<Real> one = state_of(alone, body);
      const Push<Real> push{one.centre.force, one.top.torque};
      if (push.force == Vec3<Real>::Zero() && push.torque == Vec3<Real>::Zero()) continue;
      line += work_of(push, state_of(before, body), state_of(kicked, body), h);
      clear_force(alone.centres[body]);
      if (!is_point(alone, body)) clear_torque(alone.tops[alone.top_of[body]]);
    }
  }

  LedgerLine start_;
  Lines lines_;
};

/// The books as a table of text: energy in J, momentum in kg m/s, and angular momentum about the
/// origin in kg m²/s.
template <class Real, class Backend>
std::string table_of(const Ledger<Real>& ledger, const World<Real, Backend>& world) {
  std::vector<std::pair<std::string, LedgerLine>> rows = {{"at the start", ledger.start()}};
  for (const LedgerLine& line : ledger.lines()) rows.emplace_back("+ " + line.name, line);
  rows.emplace_back("now", ledger.now(world));
  rows.emplace_back("unexplained", ledger.rest(world));
  std::size_t width = 0;
  for (const auto& row : rows) width = std::max(width, row.first.size());
  const auto cell = [](double number) {
    char text[32];
    std::snprintf(text, sizeof text, " %9.3g", number);
    return std::string(text);
  };
  std::string text(width, ' ');
  text += "  energy, J  momentum x, y, z, kg m/s      angular momentum x, y, z, kg m^2/s\n";
  for (const auto& [name, line] : rows) {
    text.append(name).append(width - name.size(), ' ').append(" ").append(cell(line.energy));
    for (const Vec3d* vector : {&line.momentum, &line.angular_momentum}) {
      text += " ";
      for (const double component : *vector) text += cell(component);
    }
    text += '\n';
  }
  return text;
}

}  // namespace tumble
