// The order of a step, written out by hand.
#include <support/box_body.hpp>
#include <support/checks.hpp>
#include <support/conveyor.hpp>
#include <support/random_world.hpp>
#include <tumble/ledger.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

/// Two forces, since only of three addends, with a push, does the order show in the sum.
template <class Real, int axis>
struct Wind {
  static constexpr std::string_view name = axis == 0 ? "wind along x" : "wind along y";
  static constexpr Quantities reads = quantity::time | quantity::position | quantity::velocity;
  Vec3<Real> force(const Particle<Real>& centre, Real time) const {
    return (Vec3<Real>::Unit(axis) * (1 + time) - centre.position / 3 - centre.velocity / 7) / 3;
  }
};

template <class Real>
struct Twist {
  static constexpr std::string_view name = "twist";
  Vec3<Real> torque(const Top<Real>& top, Real time) const {
    return rotate(top.orientation, Vec3<Real>(time, 1, 2)) / 5;
  }
};

/// Sees all that a centre has, so that it can stand in no other place of the step.
template <class Real, Phase when, int axis>
struct Swirl {
  static constexpr std::string_view name = "swirl";
  static constexpr Phase phase = when;
  Vec3<Real> velocity(const Particle<Real>& centre, const StepTime<Real>& at) const {
    const Vec3<Real> along = Vec3<Real>::Unit(axis) * (1 + at.time);
    return centre.velocity + along.cross(centre.velocity + centre.position) * at.time_step +
           centre.force / 16;
  }
};

template <class Real, Phase when, int axis>
struct SwirlOfSpin {
  static constexpr std::string_view name = "swirl of the spin";
  static constexpr Phase phase = when;
  Vec3<Real> angular_momentum_body(const Top<Real>& top, const StepTime<Real>& at) const {
    const Vec3<Real> along = rotate_back(top.orientation, Vec3<Real>::Unit(axis) * (1 + at.time));
    return top.angular_momentum_body + along.cross(top.angular_momentum_body) * at.time_step +
           top.torque / 16;
  }
};

template <class Real>
struct Shift {
  static constexpr std::string_view name = "shift";
  static constexpr Phase phase = Phase::drift;
  Vec3<Real> position(const Particle<Real>& centre, const StepTime<Real>& at) const {
    return centre.position + centre.velocity.cross(Vec3<Real>(1, 2, 3)) * at.time_step;
  }
};

/// Two of them, about axes whose turns do not commute.
template <class Real, int axis>
struct Wheel {
  static constexpr std::string_view name = axis == 0 ? "wheel along x" : "wheel along y";
  Vec3<Real> rotor_angular_momentum_body(Real time) const {
    return Vec3<Real>::Unit(axis) * (1 + time) / 8;
  }
};

/// Where and how the user pushes in each step.
template <class Real>
const Vec3<Real> force = {1, Real(0.1), 0};
template <class Real>
const Vec3<Real> point = {Real(0.3), 1, 2};

template <class Real>
void kick_by_hand(RigidBody<Real>& body, const Vec3<Real>& torque, const StepTime<Real>& at) {
  auto& [centre, top] = body;
  centre.force += Wind<Real, 0>{}.force(centre, at.time);
  centre.force += Wind<Real, 1>{}.force(centre, at.time);
  top.torque += Twist<Real>{}.torque(top, at.time);
  centre.force += force<Real>;
  top.torque += torque;
  centre.velocity = Swirl<Real, Phase::kick, 0>{}.velocity(centre, at);
  top.angular_momentum_body = SwirlOfSpin<Real, Phase::kick, 0>{}.angular_momentum_body(top, at);
  kick(centre, at.time_step), clear_force(centre);
  kick(top, at.time_step), clear_torque(top);
}

template <class Real>
void fade_by_hand(RigidBody<Real>& body, const StepTime<Real>& step) {
  auto& [centre, top] = body;
  centre.velocity = Swirl<Real, Phase::impulse, 1>{}.velocity(centre, step);
  top.angular_momentum_body =
      SwirlOfSpin<Real, Phase::impulse, 1>{}.angular_momentum_body(top, step);
  centre.velocity = Swirl<Real, Phase::damping, 2>{}.velocity(centre, step);
  top.angular_momentum_body =
      SwirlOfSpin<Real, Phase::damping, 2>{}.angular_momentum_body(top, step);
}

template <class Real>
void drift_by_hand(RigidBody<Real>& body, const StepTime<Real>& at) {
  auto& [centre, top] = body;
  const Real h = at.time_step, end = at.time + h;
  drift(centre, h);
  Conveyor{}(centre, h);
  const Wheel<Real, 0> first;
  const Wheel<Real, 1> second;
  act_on(top, RotorAct::join, first.rotor_angular_momentum_body(at.time), h);
  act_on(top, RotorAct::join, second.rotor_angular_momentum_body(at.time), h);
  act_on(top, RotorAct::turn_before, first.rotor_angular_momentum_body(at.time), h);
  act_on(top, RotorAct::turn_before, second.rotor_angular_momentum_body(at.time), h);
  if (is_gyroscopic(top))
    turn_by_splitting(top, h);
  else
    turn_steadily(top, h);
  act_on(top, RotorAct::turn_after, second.rotor_angular_momentum_body(end), h);
  act_on(top, RotorAct::turn_after, first.rotor_angular_momentum_body(end), h);
  act_on(top, RotorAct::leave, second.rotor_angular_momentum_body(end), h);
  act_on(top, RotorAct::leave, first.rotor_angular_momentum_body(end), h);
}

template <class Real>
void end_by_hand(RigidBody<Real>& body, const StepTime<Real>& step) {
  body.centre.position = Shift<Real>{}.position(body.centre, step);
  body.centre.velocity = Swirl<Real, Phase::drift, 0>{}.velocity(body.centre, step);
}

template <class Real>
void step_by_hand(RigidBody<Real>& body, Scheme scheme, const StepTime<Real>& step) {
  const Vec3<Real> torque = torque_about<Real>(body.centre.position, point<Real>, force<Real>);
  const auto part = [&](double begins, double lasts) -> StepTime<Real> {
    return {step.time + static_cast<Real>(begins) * step.time_step,
            static_cast<Real>(lasts) * step.time_step};
  };
  if (scheme == Scheme::semi_implicit_euler) {
    kick_by_hand(body, torque, part(0, 1));
    fade_by_hand(body, step);
    drift_by_hand(body, step);
  } else if (scheme == Scheme::verlet) {
    drift_by_hand(body, part(0, 0.5));
    kick_by_hand(body, torque, part(0.5, 1));
    fade_by_hand(body, step);
    drift_by_hand(body, part(0.5, 0.5));
  } else {
    const double p = 1 / (4 - std::cbrt(4.0));
    double begins = 0;
    for (const double length : {p, p, 1 - 4 * p, p, p}) {
      drift_by_hand(body, part(begins, length / 2));
      begins += length / 2;
      kick_by_hand(body, torque, part(begins, length));
      if (begins > 0.75) fade_by_hand(body, step);  // the last
      drift_by_hand(body, part(begins, length / 2));
      begins += length / 2;
    }
  }
  end_by_hand(body, step);
}

/// A box that tumbles and a ball that turns steadily, with an effect in each phase, two wheels in
/// each and one more motion.
template <class Real>
World<Real> world_of_all_phases(Scheme scheme) {
  World<Real> world(steps_per_second(16));
  world.step_by(scheme);
  RigidBody<Real> box = box_body<Real>({1, 0, 0});
  box.centre.velocity = {0, 1, 0};
  box.top.angular_momentum_body = {1, 2, Real(0.5)};
  world.add("box", box);
  RigidBody<Real> ball =
      make_rigid_body<Real>("ball", mass_properties(Sphere<Real>{1}, 2), {{0, 3, 0}}).body;
  ball.centre.velocity = {0, 0, 1};
  ball.top.angular_momentum_body = {0, 1, 1};
  world.add("ball", ball);
  world.add(Shift<Real>{});
  world.add(Swirl<Real, Phase::drift, 0>{});
  world.add(Swirl<Real, Phase::damping, 2>{});
  world.add(Swirl<Real, Phase::impulse, 1>{});
  world.add(Swirl<Real, Phase::kick, 0>{});
  world.add(Wind<Real, 0>{});
  world.add(Wind<Real, 1>{});
  const std::vector<BodyHandle> both = {world.handle_at(0), world.handle_at(1)};
  world.add(SwirlOfSpin<Real, Phase::damping, 2>{}, both);
  world.add(SwirlOfSpin<Real, Phase::impulse, 1>{}, both);
  world.add(SwirlOfSpin<Real, Phase::kick, 0>{}, both);
  world.add(Twist<Real>{}, both);
  world.add(Wheel<Real, 0>{}, both);
  world.add(Wheel<Real, 1>{}, both);
  world.add_motion(Conveyor{});
  return world;
}

}  // namespace

TEST_CASE_TEMPLATE(
    "Each scheme steps in the order that is written out by hand, and so do the "
    "judges and the books",
    Real, EVERY_PRECISION) {
  for (const Scheme scheme : {Scheme::semi_implicit_euler, Scheme::verlet, Scheme::suzuki}) {
    CAPTURE(name_of(scheme));
    World<Real> world = world_of_all_phases<Real>(scheme);
    World<Real> by_reference = world, exhaustively = world, booked = world;
    std::vector<RigidBody<Real>> by_hand = {world.body(world.handle_at(0)),
                                            world.body(world.handle_at(1))};
    Ledger<Real> books(booked);
    for (int n = 0; n < 8; ++n) {
      for (World<Real>* each : {&world, &by_reference, &exhaustively, &booked})
        for (BodyIndex i = 0; i < 2; ++i)
          each->push_at(each->handle_at(i), force<Real>, point<Real>);
      for (RigidBody<Real>& body : by_hand) step_by_hand(body, scheme, world.step_time());
      world.step();
      by_reference.step_by_reference();
      exhaustively.step_exhaustively();
      books.step(booked);
      CHECK(same_motion(world.bodies(), by_reference.bodies()));
      CHECK(same_motion(world.bodies(), exhaustively.bodies()));
      CHECK(same_motion(world.bodies(), booked.bodies()));
      for (BodyIndex i = 0; i < 2; ++i) {
        const RigidBody<Real> stepped = world.body(world.handle_at(i));
        CHECK(same_bits(stepped.centre.position, by_hand[i].centre.position));
        CHECK(same_bits(stepped.centre.velocity, by_hand[i].centre.velocity));
        CHECK(same_bits(stepped.top.angular_momentum_body, by_hand[i].top.angular_momentum_body));
        CHECK(same_bits(stepped.top.orientation.imaginary, by_hand[i].top.orientation.imaginary));
      }
    }
    // Eight steps of at most 130 passes, each with four roundings of what is less than 128.
    const LedgerLine rest = books.rest(booked);
    const double rounding = 8 * 130 * 4 * 128 * double(unit_roundoff<Real>);
    CHECK(std::abs(rest.energy) <= rounding);
    CHECK(rest.momentum.norm() <= rounding);
    CHECK(rest.angular_momentum.norm() <= rounding);
  }
}

TEST_CASE_TEMPLATE(
    "A motion of the user's own has a line in the plan, in the books and in the change log", Real,
    EVERY_PRECISION) {
  World<Real> world(steps_per_second(16));
  world.add("crate", make_particle<Real>(2));
  world.add(Gravity<Real>{});
  world.step();
  world.add_motion(Conveyor{});
  Ledger<Real> books(world);
  books.step(world);
  CHECK(world.position(world.find("crate")).x() == Real(1) / 64);
  const std::vector<PlanRow> rows = world.plan().rows;
  const auto row = std::find_if(rows.begin(), rows.end(),
                                [](const PlanRow& one) { return one.effect == "conveyor"; });
  REQUIRE(row != rows.end());
  CHECK(row->visited == 1);
  CHECK(row->reason == "every body calls for it");
  CHECK(world.plan().accuracy.order == 1);
  CHECK(books.lines().back().name == "conveyor");
  CHECK(world.change_log() ==
        std::vector<std::string>{"step 1: conveyor visits 1 of 1, before 0 ('conveyor' came)"});
  world.step_by(Scheme::verlet);
  CHECK(text_of(world.plan().accuracy) ==
        "order 1 in place of 2 (Verlet): 'conveyor' does not say its order");
}
