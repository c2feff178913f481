// A wheel inside a body: what it does to how the body turns.
#include <support/checks.hpp>
#include <support/complaint_of_step.hpp>
#include <support/exhaustive.hpp>
#include <support/random_world.hpp>
#include <tumble/ledger.hpp>
#include <tumble/reaction_wheel.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

constexpr std::array every_scheme = {Scheme::semi_implicit_euler, Scheme::verlet, Scheme::suzuki};

/// A body with these moments, kg m², that turns with ω, rad/s, both in body axes.
template <class Real>
RigidBody<Real> body_with(const Vec3<Real>& moments, const Vec3<Real>& angular_velocity) {
  RigidBody<Real> body;
  body.centre = make_particle<Real>(1);
  body.top.inverse_moments = moments.cwiseInverse();
  set_angular_velocity_body(body.top, angular_velocity);
  return body;
}

template <class Real>
World<Real> world_of(const RigidBody<Real>& body, Scheme scheme, int rate) {
  World<Real> world(steps_per_second(rate));
  world.step_by(scheme);
  world.on_warning([](const std::string&) {});
  world.add("body", body);
  return world;
}

/// A body whose moments differ, with two wheels at an angle.
template <class Real>
World<Real> world_with_two_wheels(Scheme scheme, int rate, Real torque, int locked = -1) {
  RigidBody<Real> body = body_with<Real>({3, 4, 6}, {1, Real(0.5), Real(-0.8)});
  if (locked >= 0) lock_axis(body.top, locked);
  World<Real> world = world_of(body, scheme, rate);
  world.add(ReactionWheel<Real>{
      .axis = {0, Real(0.6), Real(0.8)}, .momentum = 3, .torque = torque, .name = "first"});
  world.add(ReactionWheel<Real>{.axis = {1, 0, 0}, .momentum = -2, .torque = -2 * torque});
  return world;
}

template <class Real>
Top<Real> top_in(const World<Real>& world) {
  return world.bodies().tops[0];
}

/// The momenta of all wheels together, kg m²/s, body axes.
template <class Real>
Vec3<Real> wheels_in(const World<Real>& world, Real time) {
  Vec3<Real> sum = Vec3<Real>::Zero();
  for (const EffectInstance<Real>& entry : world.effects())
    sum += entry.effect->rotor_angular_momentum_body(time);
  return sum;
}

/// What the roundings of so many steps come to of numbers up to `largest`: a drift rounds some
/// forty times, and a step has ten of them at most.
template <class Real>
Real roundings(int steps, Real largest) {
  return Real(steps * 10 * 40) * unit_roundoff<Real> * largest;
}

/// A torque that swings, N m, world axes.
struct ShakingTorque {
  static constexpr std::string_view name = "swing";
  static constexpr Quantities reads = quantity::time;
  Vec3d torque(const Top<double>&, double time) const {
    return {3 * std::cos(2 * time), 1, 2 * std::sin(time)};
  }
};

/// Orientation and L after a second by the equation of motion itself, d(Iω)/dt = (Iω + H) × ω − Ḣ +
/// Rᵀ τ about the free axes, by Runge and Kutta's rule. H must grow evenly.
Top<double> integrated(const World<double>& start) {
  using State = Eigen::Vector<double, 7>;  // the orientation and L
  Top<double> top = top_in(start);
  const Vec3d change = wheels_in(start, 1.0) - wheels_in(start, 0.0);
  const auto rate_of = [&](const State& state, double at) -> State {
    const Quaternion<double> q{state[0], state.segment<3>(1)};
    const Vec3d L = state.tail<3>(), spin = top.inverse_moments.cwiseProduct(L);
    const Vec3d torque = rotate_back<double>(q, ShakingTorque{}.torque({}, at));
    const Quaternion<double> turning = orientation_rate_body<double>(q, spin);
    return (State() << turning.real, turning.imaginary,
            free_part<double>(top, (L + wheels_in(start, at)).cross(spin) - change + torque))
        .finished();
  };
  State state;
  state << top.orientation.real, top.orientation.imaginary, top.angular_momentum_body;
  const double h = 1.0 / 2048;
  for (double t = 0; t < 1; t += h) {
    const State a = rate_of(state, t), b = rate_of(state + h / 2 * a, t + h / 2),
                c = rate_of(state + h / 2 * b, t + h / 2), d = rate_of(state + h * c, t + h);
    state += h / 6 * (a + 2 * b + 2 * c + d);
  }
  top.orientation = normalized(Quaternion<double>{state[0], state.segment<3>(1)});
  top.angular_momentum_body = state.tail<3>();
  return top;
}

}  // namespace

TEST_CASE_TEMPLATE(
    "While motors spin wheels up, the momentum of body and wheels together stands still in the "
    "world",
    Real, EVERY_PRECISION) {
  using Carrying = TurningRules<Splitting, SplittingWithoutSine, AxisByAxis, CarryingMomentum>;
  for (std::size_t rule = 0; rule < Carrying::names.size(); ++rule)
    for (const Scheme scheme : every_scheme) {
      CAPTURE(name_of(scheme));
      CAPTURE(Carrying::names[rule]);
      World<Real> world = world_with_two_wheels<Real>(scheme, 20, 1);
      Carrying::choose(world, rule);
      const auto total = [&]() -> Vec3<Real> {
        const Top<Real> top = top_in(world);
        return rotate<Real>(top.orientation,
                            top.angular_momentum_body + wheels_in(world, world.time()));
      };
      const Vec3<Real> start = total();
      for (int n = 1; n <= 200; ++n) {
        world.step();
        CHECK((total() - start).norm() <=
              roundings<Real>(n, start.norm() + wheels_in(world, world.time()).norm()));
      }
      CHECK(top_in(world).angular_momentum_body.norm() > 9);  // of 6.7; it was not for nothing
    }
}

TEST_CASE_TEMPLATE(
    "A wheel that is spun up in a ball at rest turns it backwards by ∫ h dt / I; on a hinge, by "
    "its part along the hinge",
    Real, EVERY_PRECISION) {
  const Real inertia = 2, torque = Real(0.5);
  for (const bool is_hinged : {false, true})
    for (const Scheme scheme : every_scheme) {
      CAPTURE(name_of(scheme));
      RigidBody<Real> body = body_with<Real>({inertia, inertia, inertia}, {0, 0, 0});
      if (is_hinged) lock_axis(body.top, 1), lock_axis(body.top, 2);
      World<Real> world = world_of(body, scheme, 16);
      const ReactionWheel<Real> wheel{
          .axis = {Real(0.6), 0, Real(-0.8)}, .torque = torque, .from = 1, .until = 3};
      world.add(wheel);
      const Vec3<Real> axis = free_part<Real>(body.top, wheel.axis);
      for (int n = 1; n <= 80; ++n) {
        world.step();
        const Real t = world.time(), running = std::clamp(t, Real(1), Real(3)) - 1;
        const Real h = torque * running;  // and its integral: while it runs, and after that
        const Real angle = (h * running / 2 + h * std::max(t - 3, Real(0))) / inertia;
        const Top<Real> top = top_in(world);
        CHECK(distance<Real>(wheel.rotor_angular_momentum_body(t), h * wheel.axis) <=
              roundings<Real>(1, 1));
        CHECK(angle_between(top.orientation, quaternion_of_rotation_vector<Real>(-angle * axis)) <=
              roundings<Real>(n, 2));
        CHECK(distance<Real>(angular_velocity_body(top), -h / inertia * axis) <=
              roundings<Real>(n, 2));
      }
    }
}

TEST_CASE_TEMPLATE(
    "A symmetric body with a wheel on its axis nutates with (h + (I₃ − I₁) ω₃)/I₁, exactly in any "
    "step",
    Real, EVERY_PRECISION) {
  const Real I1 = 2, I3 = 3, h = 5, along = Real(0.75);
  const Vec3<Real> spin(1, Real(0.5), along), total(I1 * spin.x(), I1 * spin.y(), I3 * along + h);
  // I₁ dω₁/dt = Π₂ ω₃ − Π₃ ω₂ and I₁ dω₂/dt = Π₃ ω₁ − Π₁ ω₃, with Π₃ = h + I₃ ω₃.
  const Real rate = (h + (I3 - I1) * along) / I1;
  for (const Scheme scheme : every_scheme) {
    CAPTURE(name_of(scheme));
    World<Real> world = world_of(body_with<Real>({I1, I1, I3}, spin), scheme, 4);
    world.add(ReactionWheel<Real>{.momentum = h});
    for (int n = 1; n <= 40; ++n) {
      world.step();
      const Top<Real> top = top_in(world);
      const Real t = world.time();
      const auto c = static_cast<Real>(std::cos(double(rate * t))),
                 s = static_cast<Real>(std::sin(double(rate * t)));
      const Vec3<Real> now(c * spin.x() - s * spin.y(), s * spin.x() + c * spin.y(), along);
      // The body turns about Π with |Π|/I₁, and beneath that about its own axis.
      const Quaternion<Real> turned = quaternion_of_rotation_vector<Real>(t / I1 * total) *
                                      quaternion_of_rotation_vector<Real>({0, 0, -t * rate});
      CHECK(distance<Real>(angular_velocity_body(top), now) <= roundings<Real>(n, 10));
      CHECK(angle_between(top.orientation, turned) <= roundings<Real>(n, 10));
    }
  }
}

TEST_CASE(
    "With wheels that run evenly a world keeps the order of its scheme, beside locked axes too") {
  for (const int locked : {-1, 0, 1, 2})
    for (const double torque : {0.0, 1.5})
      for (const Scheme scheme : every_scheme) {
        CAPTURE(locked);
        CAPTURE(torque);
        CAPTURE(name_of(scheme));
        const auto world_at = [&](int rate) {
          World<double> world = world_with_two_wheels<double>(scheme, rate, torque, locked);
          world.add(ShakingTorque{});
          return world;
        };
        const Top<double> truth = integrated(world_at(1));
        const auto error_at = [&](int rate) {
          World<double> world = world_at(rate);
          for (int n = 0; n < rate; ++n) world.step();
          const Top<double> top = top_in(world);
          return angle_between(top.orientation, truth.orientation) +
                 (top.angular_momentum_body - truth.angular_momentum_body).norm();
        };
        const int order = order_of(scheme);
        CHECK(std::lround(std::log2(error_at(64) / error_at(128))) == order);
        // Suzuki's order is not sure of a motor that starts or stops within a step.
        CHECK(world_at(1).plan().accuracy.order == (torque == 0 ? order : std::min(order, 2)));
      }
}

TEST_CASE_TEMPLATE(
    "A spin about the middle axis is stable if a wheel makes its momentum more than I₃ Ω or less "
    "than I₁ Ω",
    Real, EVERY_PRECISION) {
  const Real I1 = 2, I2 = 3, I3 = 4, spin = 2;
  const Real upper = (I3 - I2) * spin, lower = -(I2 - I1) * spin;
  for (const Real h : {Real(1.05) * upper, 2 * upper, Real(1.05) * lower, 2 * lower,
                       Real(0.95) * upper, Real(0), Real(0.95) * lower}) {
    CAPTURE(h);
    // Nearby, I₁ ω̇₁ = (h − (I₃ − I₂) Ω) ω₃ = A ω₃ and I₃ ω̇₃ = −(h + (I₂ − I₁) Ω) ω₁ = −B ω₁.
    const Real A = h - upper, B = h - lower;
    World<Real> world =
        world_of(body_with<Real>({I1, I2, I3}, {Real(1e-3), spin, Real(1e-3)}), Scheme::verlet, 50);
    world.add(ReactionWheel<Real>{.axis = {0, 1, 0}, .momentum = h});
    const auto tilt = [&] {
      const Vec3<Real> w = angular_velocity_body(top_in(world));
      return std::hypot(w.x(), w.z());
    };
    const Real first = tilt();
    Real most = first;
    for (int n = 0; n < 60 * 50; ++n) {
      world.step();
      most = std::max(most, tilt());
    }
    if (A * B > 0) {  // I₁ B ω₁² + I₃ A ω₃² stays what it was, up to the square of the tilt
      const Real one = std::abs(I1 * B), three = std::abs(I3 * A);
      CHECK(most <= Real(1.1) * first * std::sqrt((one + three) / (2 * std::min(one, three))));
    } else {  // it grows by e¹³ in a minute at least, until it turns over
      CHECK(std::sqrt(-A * B / (I1 * I3)) * 60 > 13);
      CHECK(most > 300 * first);
    }
  }
}

TEST_CASE(
    "A wheel in a disc at rest stiffens its axis, and limits the step, as the same spin of the "
    "disc does") {
  const auto disc = [](double spin, double wheel, Scheme scheme, int rate = 10, int locked = -1) {
    RigidBody<double> body = body_with<double>({1, 1, 2}, {0, 0, spin});
    if (locked >= 0) lock_axis(body.top, locked);
    World<double> world = world_of(body, scheme, rate);
    world.add(ReactionWheel<double>{.momentum = wheel, .name = "first"});
    for (const double side : {1.0, -1.0})
      world.add(SpringToPoint<double>{.spring = {.stiffness = 50, .rest_length = 1},
                                      .anchor = {0.01 * side, 0, 3 * side},
                                      .attachment = {0, 0, side}},
                {world.handle_at(0)});
    return world;
  };
  for (const Scheme scheme : every_scheme) {
    CAPTURE(name_of(scheme));
    World<double> spun = disc(9, 0, scheme), wheeled = disc(0, 18, scheme);
    CHECK(spun.step_limit().time_step == wheeled.step_limit().time_step);
    CHECK(wheeled.step_limit().time_step < 0.9 * disc(0, 0, scheme).step_limit().time_step);
    CHECK(wheeled.step_limit().nutation_rate == 18);
    for (int n = 1; n <= 20; ++n) {
      spun.step(), wheeled.step();
      const auto axis = [](const World<double>& world) {
        return rotate<double>(top_in(world).orientation, {0, 0, 1});
      };
      CHECK(distance<double>(axis(spun), axis(wheeled)) <= roundings<double>(n, 18));
    }
    CHECK(rotate<double>(top_in(spun).orientation, {0, 0, 1}).x() != 0);
  }
  // About a locked axis a wheel makes the spin turn; not where one of the others is locked.
  CHECK(disc(0, 18, Scheme::verlet, 10, 2).step_limit().nutation_rate == 18);
  CHECK(disc(0, 18, Scheme::verlet, 10, 1).step_limit().nutation_rate == 0);
  World<double> world = disc(0, 0, Scheme::verlet, 9);
  std::string told;
  world.on_warning([&](const std::string& warning) { told += warning; });
  world.step();
  CHECK(told == "");
  world.add(ReactionWheel<double>{.momentum = 18});
  world.step();
  CHECK(told.ends_with(
      "since a wheel spins in 'body', and its nutation turns by 115 degrees in a step"));
}

TEST_CASE_TEMPLATE(
    "The books close with a line for the wheel: the momentum that it took, and the work of its "
    "motor on the body",
    Real, EVERY_PRECISION) {
  for (const Scheme scheme : every_scheme) {
    CAPTURE(name_of(scheme));
    World<Real> world = world_of(body_with<Real>({2, 2, 4}, {0, 0, 3}), scheme, 10);
    world.add(ReactionWheel<Real>{.momentum = 1, .torque = 2, .from = 1, .until = 3});
    Ledger<Real> ledger(world);
    for (int n = 0; n < 40; ++n) ledger.step(world);
    REQUIRE(ledger.lines().size() == 2);
    const LedgerLine& line = ledger.lines()[0];
    CHECK(line.name == "reaction wheel");
    // −∫ ḣ ω₃ dt with ω₃ = 3 − (h − 1)/4, while h grows by 4; of energies up to (12 + 5)²/8 J.
    CHECK(std::abs(line.energy - (-3 * 4 + 4 * 4 / 8.0)) <= double(roundings<Real>(40, 36)));
    CHECK((line.angular_momentum - Vec3d(0, 0, -4)).norm() <= double(roundings<Real>(40, 36)));
    const LedgerLine rest = ledger.rest(world);
    CHECK(std::abs(rest.energy) + rest.angular_momentum.norm() <=
          roundings<double>(40, 36));  // the books are kept in double, whatever the world rounds
  }
}

TEST_CASE_TEMPLATE("The plan says whom a wheel visits, and why it visits none of the others", Real,
                   EVERY_PRECISION) {
  World<Real> world(steps_per_second(60));
  world.add("point", make_particle<Real>(1));
  RigidBody<Real> fixed = body_with<Real>({1, 2, 3}, {0, 0, 0}), door = fixed;
  fixed.top.inverse_moments.setZero();
  lock_axis(door.top, 1);
  world.add("fixed", fixed);
  world.add("door", door);
  const auto row = [&](const std::string& name) {
    for (const PlanRow& one : world.plan().rows)
      if (one.effect == name) return one;
    return PlanRow{};
  };
  world.add("box", body_with<Real>({1, 2, 3}, {0, 0, 0}));
  const EffectHandle wheel = world.add(ReactionWheel<Real>{.momentum = 1});
  const PlanRow told = row("reaction wheel");
  CHECK(name_of(told.phase) == "turn");
  CHECK(told.visited == 2);
  CHECK(told.reads == "time");
  CHECK(told.writes == "orientation, spin");
  CHECK(told.reason == "not 1: points do not turn; not 1: locked about every axis");
  CHECK(row("tumbling: splitting").visited == 1);  // at rest as it is
  CHECK(row("kick of the spin").visited == 0);
  CHECK(world.plan().unknown.empty());
  world.change(wheel, ReactionWheel<Real>{});
  CHECK(row("reaction wheel").visited == 0);
  CHECK(row("reaction wheel").reason.ends_with("not 2: the wheel stands still"));
  CHECK(row("tumbling: splitting").visited == 0);
  world.change(wheel, ReactionWheel<Real>{.torque = 1});
  CHECK(row("reaction wheel").visited == 2);
}

TEST_CASE_TEMPLATE(
    "By its plan, by the reference run and exhaustively bodies with wheels turn alike to the bit",
    Real, EVERY_PRECISION) {
  for (const Scheme scheme : every_scheme) {
    RandomGenerator dice(47);
    World<Real> world = world_with_two_wheels<Real>(scheme, 60, 1);
    for (int n = 0; n < 30; ++n) add_random_body(world, dice, "other " + std::to_string(n));
    world.add(ReactionWheel<Real>{.name = "still"});
    World<Real> by_reference = world, exhaustive = world;
    for (int n = 0; n < 20; ++n) {
      world.step(), by_reference.step_by_reference(), exhaustive.step_exhaustively();
      REQUIRE(difference_in_value(world.bodies(), by_reference.bodies()) == "");
      REQUIRE(difference_in_value(world.bodies(), exhaustive.bodies()) == "");
    }
  }
}

TEST_CASE_TEMPLATE("A step in which a wheel turns its body too far is taken back, and blamed", Real,
                   EVERY_PRECISION) {
  for (const Scheme scheme : every_scheme) {
    World<Real> world = world_with_two_wheels<Real>(scheme, 10, 1);
    world.step();
    const Bodies<Real> before = world.bodies();
    const auto blame = [&](Real momentum) {
      const EffectHandle wheel =
          world.add(ReactionWheel<Real>{.momentum = momentum, .name = "too fast"});
      const std::string complaint = complaint_of_step([&] { world.step(); });
      world.remove(wheel);
      CHECK(same_motion(world.bodies(), before));
      return complaint;
    };
    const Real limit = 2 * SineCosineConstants<Real>::limit;
    const std::array lasts = {Real(1), Real(0.5), Real(0.20725)};  // the first drift, of 0.1 s
    // The momentum that turns the axis with 6 kg m² by the limit in that.
    const Real momentum = limit * 6 / (lasts[static_cast<std::size_t>(scheme)] * Real(0.1));
    CHECK(blame(4 * momentum).find("too fast would turn it by ") != std::string::npos);
    CHECK(blame(std::numeric_limits<Real>::max()).find("too fast") != std::string::npos);
    // What turns it too far is the sum, which no wheel alone has spoilt.
    const std::string complaint = blame(Real(1.5) * momentum), words = "it would turn by ";
    REQUIRE(complaint.find(words) != std::string::npos);
    CHECK(std::abs(std::stod(complaint.substr(complaint.find(words) + words.size()))) > limit);
  }
}

TEST_CASE_TEMPLATE("A wheel is refused with its value, its unit and the rule", Real,
                   EVERY_PRECISION) {
  const Real nan = std::numeric_limits<Real>::quiet_NaN(), infinity = 1 / Real(0);
  const auto refusal = [](const ReactionWheel<Real>& wheel) {
    World<Real> world = world_of(body_with<Real>({1, 2, 3}, {0, 0, 0}), Scheme::verlet, 60);
    const std::string complaint = complaint_of([&] { world.add(wheel); });
    CHECK(world.effects().empty() == (complaint != "nothing thrown"));
    return complaint;
  };
  CHECK(refusal({}) == "nothing thrown");
  CHECK(refusal({.axis = {0, 0, 2}}) ==
        "axis of a reaction wheel is (0, 0, 2); it must have length 1");
  // A square of 1 + 8 epsilon is let through, and one of 1 + 9 epsilon is not.
  const Real epsilon = std::numeric_limits<Real>::epsilon(), longer = 1 + 4 * epsilon;
  CHECK(refusal({.axis = {0, 0, longer}}) == "nothing thrown");
  CHECK(refusal({.axis = {0, std::sqrt(epsilon), longer}}).ends_with("it must have length 1"));
  CHECK(refusal({.axis = {0, nan, 1}}).ends_with("(0, nan, 1); every component must be finite"));
  CHECK(refusal({.momentum = infinity}) ==
        "momentum of a reaction wheel is inf kg m^2/s; it must be finite");
  CHECK(refusal({.torque = nan}) == "torque of a reaction wheel is nan N m; it must be finite");
  CHECK(refusal({.from = -infinity}) == "start of a reaction wheel is -inf s; it must be finite");
  for (const Real until : {Real(1), nan})
    CHECK(refusal({.from = 2, .until = until}) ==
          "end of a reaction wheel is " + text_of(until) + " s; it must not lie before the start");
  CHECK(refusal({.torque = std::numeric_limits<Real>::max(), .until = 2}) ==
        "momentum of a reaction wheel at the end is inf kg m^2/s; it must be finite");
}
