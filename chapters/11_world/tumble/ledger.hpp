/// @file
/// The books of a world: what each effect put in and took out, and what remains unexplained.
#pragma once

#include <cstdio>
#include <tumble/energy.hpp>
#include <tumble/ledger_line.hpp>

namespace tumble {

/// The books. They are kept beside the world and never touch it: a step with books is the same to
/// the bit as one without. They take the step on a copy first, one effect after another.
template <class Real>
class Ledger {
 public:
  /// Begins with what the world's bodies have now.
  template <class Backend>
  explicit Ledger(const World<Real, Backend>& world)
      : start_(holdings_of(world.bodies())),
        stored_at_start_(stored_energy(world)),
        largest_kinetic_(start_.energy) {}

  /// One step of the world, booked. If it fails, nothing is booked.
  template <class Backend>
  void step(World<Real, Backend>& world) {
    Lines lines = lines_;
    double kinetic = 0;
    world.step(
        [&] { kinetic = book_step(world.bodies(), world.step_plan(), world.step_time(), lines); });
    lines_ = std::move(lines);
    largest_kinetic_ = std::max(largest_kinetic_, kinetic);
  }

  /// What the bodies had when the books were opened.
  const LedgerLine& start() const { return start_; }
  /// What the effects had stored then, J: see stored_energy().
  double stored_at_start() const { return stored_at_start_; }
  /// The largest kinetic energy at the start or after a step, J.
  double largest_kinetic() const { return largest_kinetic_; }

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

 private:
  using Lines = std::vector<LedgerLine>;

  static LedgerLine& line_of(Lines& lines, const std::string& name) {
    for (LedgerLine& line : lines)
      if (line.name == name) return line;
    lines.push_back({name, 0, Vec3d::Zero(), Vec3d::Zero()});
    return lines.back();
  }

  /// What forces and torques of one name give to each body in one kick.
  struct Share {
    std::string name;
    std::vector<Push<Real>> pushes;
  };

  /// The step on a copy. What changes momenta or places at once is booked as the difference that it
  /// makes; forces and torques, which act together, each by its share of the kick, see work_of().
  /// @return the kinetic energy after it, J
  //! [book_step]
  static double book_step(Bodies<Real> bodies, const StepPlan<Real>& plan,
                          const StepTime<Real>& step, Lines& lines) {
    constexpr Quantities sums = quantity::force | quantity::torque;
    std::vector<Share> shares;  // of one kick
    Quantities spent;           // which sums it has used up
    for (const Pass<Real> pass : Passes(plan)) {
      const bool is_input = pass.row.kind == PassKind::input;
      const std::string name = is_input ? "input" : instance_of(pass, plan).effect->name();
      if (is_input || instance_of(pass, plan).effect->traits().writes.has_any(sums)) {
        if (std::exchange(spent, {}) != Quantities{}) shares.clear();
        shares.push_back({name, pushes_of(pass, plan, bodies, step)});
        line_of(lines, name);  // lines stand in the order of the step
        run(pass, plan, members_of(pass, plan), bodies, step);
        continue;
      }
      const Bodies<Real> before = bodies;
      run(pass, plan, members_of(pass, plan), bodies, step);
      const Quantities acting = (instance_of(pass, plan).effect->traits().reads & sums) - spent;
      spent = spent | acting;
      if (acting != Quantities{})
        book_kick(shares, acting, before, bodies, step_time_of(pass, step).time_step, lines);
      else
        line_of(lines, name) += gained_since(before, bodies);
    }
    return holdings_of(bodies).energy;
  }
  //! [book_step]

  /// Books each share of a kick of `time_step` seconds. `acting` says which sum made it: that of
  /// the forces, of the torques, or both.
  static void book_kick(const std::vector<Share>& shares, Quantities acting,
                        const Bodies<Real>& before, const Bodies<Real>& after, Real time_step,
                        Lines& lines) {
    for (const Share& share : shares)
      for (BodyIndex body = 0; body < share.pushes.size(); ++body) {
        Push<Real> push = share.pushes[body];
        if (!acting.has(quantity::force)) push.force.setZero();
        if (!acting.has(quantity::torque)) push.torque.setZero();
        if (push.force != Vec3<Real>::Zero() || push.torque != Vec3<Real>::Zero())
          line_of(lines, share.name) +=
              work_of(push, state_of(before, body), state_of(after, body), time_step);
      }
  }

  static LedgerLine gained_since(const Bodies<Real>& before, const Bodies<Real>& after) {
    LedgerLine gained = holdings_of(after);
    gained -= holdings_of(before);
    return gained;
  }

  /// What a pass alone adds to the sums of each body.
  static std::vector<Push<Real>> pushes_of(const Pass<Real>& pass, const StepPlan<Real>& plan,
                                           Bodies<Real> bodies, const StepTime<Real>& step) {
    for (Particle<Real>& centre : bodies.centres) clear_force(centre);
    for (Top<Real>& top : bodies.tops) clear_torque(top);
    run(pass, plan, members_of(pass, plan), bodies, step);
    std::vector<Push<Real>> pushes;
    for (BodyIndex body = 0; body < bodies.centres.size(); ++body)
      pushes.push_back({state_of(bodies, body).centre.force, state_of(bodies, body).top.torque});
    return pushes;
  }

  LedgerLine start_;
  double stored_at_start_, largest_kinetic_;
  Lines lines_;
};

/// Kinetic and stored energy then and now, if anything stores some; else nothing. The books close
/// whatever a step does, so where no effect takes or gives energy it is their sum that tells of a
/// step too long for a force, such as near a point that attracts. It is held against the largest
/// kinetic energy so far: at a turning point there is none. Kick and drift swing the energy of a
/// spring by w h of it from least to most (chapter 6), so after a swing w h is over 0.1. From rest
/// they are off by one part in n after n steps, so within ten steps no step is short enough.
template <class Real, class Backend>
std::string energies_of(const Ledger<Real>& ledger, const World<Real, Backend>& world) {
  bool is_stored = false, is_kept = true;
  for (const EffectInstance<Real>& instance : world.effects()) {
    const EffectTraits<Real>& traits = instance.effect->traits();
    if (instance.members.size() == 0 && !traits.finds_pairs) continue;
    is_stored |= traits.stores_energy;
    is_kept &= traits.stores_energy && !traits.depends_on_speed;
  }
  for (const LedgerLine& line : ledger.lines()) is_kept &= line.name != "input";
  if (!is_stored) return {};
  const double before = ledger.start().energy, after = ledger.now(world).energy;
  const double stored_before = ledger.stored_at_start(), stored = stored_energy(world);
  char text[256];
  std::snprintf(
      text, sizeof text,
      "kinetic + stored = sum, J: %.4g + %.4g = %.4g at the start, %.4g + %.4g = %.4g now\n",
      before, stored_before, before + stored_before, after, stored, after + stored);
  const bool has_drifted =
      std::abs(after + stored - before - stored_before) > ledger.largest_kinetic() / 10;
  return std::string(text) + (is_kept && has_drifted
                                  ? "no effect takes or gives energy, but the sum has changed by "
                                    "more than a tenth of the "
                                    "largest kinetic energy: steps were too long for a force\n"
                                  : "");
}

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
  return text + energies_of(ledger, world);
}

}  // namespace tumble
