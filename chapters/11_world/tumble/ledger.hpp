/// @file
/// The books of a world: what each effect put in and took out, and what nobody can account for.
#pragma once

#include <cstdio>
#include <tumble/world.hpp>

namespace tumble {

/// A line of the books: an amount of energy (J), momentum (kg m/s) and angular momentum about the
/// world's origin (kg m²/s), world axes.
struct LedgerLine {
  std::string name;
  double energy = 0;
  Vec3d momentum = Vec3d::Zero();
  Vec3d angular_momentum = Vec3d::Zero();

  LedgerLine& operator+=(const LedgerLine& other) {
    energy += other.energy;
    momentum += other.momentum;
    angular_momentum += other.angular_momentum;
    return *this;
  }
  LedgerLine& operator-=(const LedgerLine& other) {
    energy -= other.energy;
    momentum -= other.momentum;
    angular_momentum -= other.angular_momentum;
    return *this;
  }
};

/// What one body has.
template <class Real>
LedgerLine holdings_of(const BodyState<Real>& body) {
  const Particle<double> centre{.position = body.centre.position.template cast<double>(),
                                .velocity = body.centre.velocity.template cast<double>(),
                                .inverse_mass = static_cast<double>(body.centre.inverse_mass)};
  const Vec3d angular_velocity = angular_velocity_body(body.top).template cast<double>();
  const Vec3d angular_momentum = body.top.angular_momentum_body.template cast<double>();
  const Quaternion<double> q{static_cast<double>(body.top.orientation.real),
                             body.top.orientation.imaginary.template cast<double>()};
  const Vec3d p = momentum(centre);
  return {{},
          kinetic_energy(centre) + angular_velocity.dot(angular_momentum) / 2,
          p,
          centre.position.cross(p) + rotate(q, angular_momentum)};
}

/// What all bodies have.
template <class Real>
LedgerLine holdings_of(const Bodies<Real>& bodies) {
  LedgerLine sum;
  for (BodyIndex body = 0; body < bodies.centres.size(); ++body)
    sum += holdings_of(state_of(bodies, body));
  return sum;
}

/// What a push gives a body in the kick of `time_step` seconds, exactly but for rounding. `before`
/// and `after` are the body around the kick, when it has not yet moved.
///
/// With Δv = h ΣF/m the energy grows by ½ m (v' + v)·(v' − v) = h ΣF · ½ (v + v'). The sum falls
/// apart into the effects' shares, and the same holds for L, with ½ (ω + ω').
//! [work_of]
template <class Real>
LedgerLine work_of(const Push<Real>& push, const BodyState<Real>& before,
                   const BodyState<Real>& after, Real time_step) {
  const double h = static_cast<double>(time_step);
  LedgerLine work;
  if (!is_static(before.centre)) {
    const Vec3d mean = (before.centre.velocity.template cast<double>() +
                        after.centre.velocity.template cast<double>()) /
                       2;
    work.momentum = h * push.force.template cast<double>();
    work.energy = work.momentum.dot(mean);
    work.angular_momentum = before.centre.position.template cast<double>().cross(work.momentum);
  }
  const Vec3<Real> torque_body =
      free_part<Real>(before.top, rotate_back(before.top.orientation, push.torque));
  const Vec3d mean_spin = (angular_velocity_body(before.top).template cast<double>() +
                           angular_velocity_body(after.top).template cast<double>()) /
                          2;
  work.energy += h * torque_body.template cast<double>().dot(mean_spin);
  work.angular_momentum +=
      h * rotate<Real>(before.top.orientation, torque_body).template cast<double>();
  return work;
}
//! [work_of]

/// The books. They are kept beside the world and never touch it: a step with books is the same to
/// the bit as one without.
template <class Real>
class Ledger {
 public:
  template <class Keeping>
  explicit Ledger(const World<Real, Keeping>& world) : start_(holdings_of(world.bodies())) {}

  /// One step of the world, booked. If it fails, nothing is booked.
  //! [ledger_step]
  template <class Keeping>
  void step(World<Real, Keeping>& world) {
    const Bodies<Real> before = world.bodies();
    const Real time = world.time();
    const std::vector<Pass<Real>> passes = world.passes();
    std::vector<Line> lines = lines_;
    for (const Pass<Real>& pass : passes)
      if (pushes(*pass.effect) || pass.effect->phase() > Phase::kick) line_of(lines, *pass.effect);
    Bodies<Real> kicked = before;
    LedgerLine last;
    bool all_kicked = false;
    world.step([&](const AnyEffect<Real>& effect) {
      if (effect.phase() <= Phase::kick) {
        if (effect.phase() == Phase::kick) kicked = world.bodies();
        return;
      }
      if (!all_kicked) last = holdings_of(kicked);
      all_kicked = true;
      LedgerLine change = holdings_of(world.bodies());
      const LedgerLine now = change;
      change -= last;
      line_of(lines, effect) += change;
      last = now;
    });
    for (const Pass<Real>& pass : passes)
      book_pushes(pass, before, kicked, time, world.time_step(), lines);
    lines_ = std::move(lines);
  }
  //! [ledger_step]

  /// What the bodies had when the books were opened.
  const LedgerLine& start() const { return start_; }

  /// What they have now.
  template <class Keeping>
  LedgerLine now(const World<Real, Keeping>& world) const {
    return holdings_of(world.bodies());
  }

  /// What each effect put in so far.
  std::vector<LedgerLine> lines() const {
    std::vector<LedgerLine> lines;
    for (const Line& line : lines_) lines.push_back(line.sum);
    return lines;
  }

  /// What is neither start nor any line: rounding, if the books are right.
  template <class Keeping>
  LedgerLine rest(const World<Real, Keeping>& world) const {
    LedgerLine rest = now(world);
    rest -= start_;
    for (const Line& line : lines_) rest -= line.sum;
    return rest;
  }

  /// The energy (J) stored in the effects that know theirs: gravity and springs.
  template <class Keeping>
  static double stored(World<Real, Keeping>& world) {
    const Bodies<Real>& bodies = world.bodies();
    double sum = 0;
    for (const Pass<Real>& pass : world.passes()) {
      if (!pass.effect->traits().stores_energy) continue;
      const std::vector<BodyIndex>& members = pass.group.members;
      if (pass.effect->traits().joins_two)
        for (std::size_t i = 0; i < members.size(); i += 2)
          sum += static_cast<double>(pass.effect->potential_energy(
              state_of(bodies, members[i]), state_of(bodies, members[i + 1])));
      else
        for_each_index(pass.group, bodies.centres.size(), [&](BodyIndex body) {
          sum += static_cast<double>(pass.effect->potential_energy(state_of(bodies, body)));
        });
    }
    return sum;
  }

 private:
  struct Line {
    const AnyEffect<Real>* effect;
    LedgerLine sum;
  };

  static LedgerLine& line_of(std::vector<Line>& lines, const AnyEffect<Real>& effect) {
    for (Line& line : lines)
      if (line.effect == &effect || line.sum.name == effect.name()) return line.sum;
    lines.push_back({&effect, {effect.name(), 0, Vec3d::Zero(), Vec3d::Zero()}});
    return lines.back().sum;
  }

  static bool pushes(const AnyEffect<Real>& effect) {
    return effect.traits().gives_force || effect.traits().gives_acceleration ||
           effect.traits().gives_torque;
  }

  static void book_pushes(const Pass<Real>& pass, const Bodies<Real>& before,
                          const Bodies<Real>& kicked, Real time, Real time_step,
                          std::vector<Line>& lines) {
    const AnyEffect<Real>& effect = *pass.effect;
    if (!pushes(effect)) return;
    LedgerLine& line = line_of(lines, effect);
    const auto book = [&](BodyIndex body, const Push<Real>& push) {
      line += work_of(push, state_of(before, body), state_of(kicked, body), time_step);
    };
    const std::vector<BodyIndex>& members = pass.group.members;
    if (effect.traits().joins_two) {
      for (std::size_t i = 0; i < members.size(); i += 2) {
        const PairPush<Real> push =
            effect.push_on(state_of(before, members[i]), state_of(before, members[i + 1]), time);
        book(members[i], {push.force_on_first, push.torque_on_first});
        book(members[i + 1], {-push.force_on_first, push.torque_on_second});
      }
    } else {
      const bool tops = effect.traits().visits_tops;
      for_each_index(pass.group, tops ? before.tops.size() : before.centres.size(),
                     [&](BodyIndex member) {
                       const BodyIndex body = tops ? before.body_of[member] : member;
                       book(body, effect.push_on(state_of(before, body), time));
                     });
    }
  }

  LedgerLine start_;
  std::vector<Line> lines_;
};

/// The books as a table of text: energy in J, momentum in kg m/s, and angular momentum about the
/// origin in kg m²/s.
template <class Real, class Keeping>
std::string table_of(const Ledger<Real>& ledger, const World<Real, Keeping>& world) {
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
