// Which effect a step is blamed on that could not be taken, and what is said of it.
#include <support/box_body.hpp>
#include <support/checks.hpp>
#include <tumble/air_and_water.hpp>
#include <tumble/gravity.hpp>
#include <tumble/solids.hpp>
#include <tumble/spheres.hpp>
#include <tumble/springs.hpp>
#include <tumble/thruster.hpp>
#include <tumble/world.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

template <class Real>
constexpr Real most = std::numeric_limits<Real>::max();

/// The error of a step that must fail.
template <class Step>
SimulationError failure_in(const Step& step) {
  try {
    step();
  } catch (const SimulationError& error) {
    return error;
  }
  return {"nothing thrown", "", "", -1};
}

template <class AnyWorld>
SimulationError failure_of(AnyWorld& world) {
  return failure_in([&] { world.step(); });
}

/// An effect that joins two bodies and gives a force or a torque that is none.
template <class Real>
struct BrokenJoint {
  static constexpr std::string_view name = "broken joint";
  bool breaks_force;
  PairPush<Real> push(const BodyState<Real>&, const BodyState<Real>&, Real) const {
    const Vec3<Real> bad(0, std::numeric_limits<Real>::quiet_NaN(), 0);
    PairPush<Real> push;
    (breaks_force ? push.force_on_first : push.torque_on_second) = bad;
    return push;
  }
};

/// The same force on everybody.
template <class Real>
struct Pull {
  std::string name;
  Vec3<Real> pull;
  Vec3<Real> force(const Particle<Real>&, Real) const { return pull; }
};

/// Writes a velocity that is no number.
template <class Real, Phase when>
struct Spoiler {
  static constexpr Phase phase = when;
  std::string name;
  Vec3<Real> velocity(const Particle<Real>&, const StepTime<Real>&) const {
    return {std::numeric_limits<Real>::quiet_NaN(), 0, 0};
  }
};

/// Doubles the velocity, in the phase of the forces.
template <class Real>
struct Doubler {
  static constexpr Phase phase = Phase::force;
  static constexpr std::string_view name = "doubler";
  Vec3<Real> velocity(const Particle<Real>& centre, const StepTime<Real>&) const {
    return 2 * centre.velocity;
  }
};

/// A torque as large as a number can be.
template <class Real>
struct Twist {
  std::string name;
  Vec3<Real> torque(const Top<Real>&, Real) const { return {0, 0, most<Real>}; }
};

/// Gives no number once the body has moved, or turned.
template <class Real>
struct Tripwire {
  static constexpr Phase phase = Phase::drift;
  static constexpr std::string_view name = "tripwire";
  Vec3<Real> start = Vec3<Real>::Zero();
  Vec3<Real> velocity(const BodyState<Real>& body, const StepTime<Real>&) const {
    const bool is_there =
        body.centre.position == start && body.top.orientation.imaginary == Vec3<Real>::Zero();
    return is_there ? body.centre.velocity
                    : Vec3<Real>(0, 0, std::numeric_limits<Real>::quiet_NaN());
  }
};

/// Writes something that is no number into one quantity.
template <class Real>
struct BadPlace {
  static constexpr Phase phase = Phase::drift;
  static constexpr std::string_view name = "bad place";
  Vec3<Real> position(const Particle<Real>&, const StepTime<Real>&) const {
    return {0, std::numeric_limits<Real>::infinity(), 0};
  }
};
template <class Real>
struct BadSpin {
  static constexpr Phase phase = Phase::kick;
  static constexpr std::string_view name = "bad spin";
  Vec3<Real> angular_momentum_body(const Top<Real>&, const StepTime<Real>&) const {
    return {0, 0, std::numeric_limits<Real>::infinity()};
  }
};
template <class Real>
struct BadFacing {
  static constexpr Phase phase = Phase::drift;
  static constexpr std::string_view name = "bad facing";
  Quaternion<Real> given;
  Quaternion<Real> orientation(const Top<Real>&, const StepTime<Real>&) const { return given; }
};

}  // namespace

TEST_CASE_TEMPLATE("Forces that are finite each and infinite together are blamed on no effect",
                   Real, EVERY_PRECISION) {
  for (const bool with_acceleration : {false, true}) {
    World<Real> world(steps_per_second(1));
    world.add("ball", make_particle<Real>(1));
    world.add(Pull<Real>{"one", {most<Real>, 0, 0}});
    world.add(Pull<Real>{"other", {most<Real>, 0, 0}});
    // It acts on the velocity, after the sum has overflowed.
    if (with_acceleration) world.add(GravityAsAcceleration<Real>{{0, 0, -2}});
    world.add(LinearDamping<Real>{.rate = 1});  // and this on what is infinite by then
    const SimulationError error = failure_of(world);
    CHECK(error.body == "ball");
    CHECK(error.effect == "");
    CHECK(std::string(error.what()) ==
          std::string("'ball' at 0 s (step 0): with a velocity of (inf, 0, ") +
              (with_acceleration ? "-2" : "0") +
              ") m/s the step would lead to no finite position; the world is as it was before "
              "this step");
  }
}

TEST_CASE_TEMPLATE("Torques that are finite each and infinite together are blamed on no effect",
                   Real, EVERY_PRECISION) {
  World<Real> world(steps_per_second(1));
  world.add("box", box_body<Real>({0, 0, 0}));
  world.add(Twist<Real>{"one"}, {world.find("box")});
  world.add(Twist<Real>{"other"}, {world.find("box")});
  const SimulationError error = failure_of(world);
  CHECK(error.effect == "");
  CHECK(std::string(error.what()).find("it would turn by ") != std::string::npos);
}

TEST_CASE_TEMPLATE("A body that loses its place is named before one that loses its orientation",
                   Real, EVERY_PRECISION) {
  World<Real> world(steps_per_second(1));
  world.add("first", box_body<Real>({0, 0, 0}));
  world.add("second", box_body<Real>({9, 0, 0}));
  world.add(BadSpin<Real>{}, {world.find("first")});
  world.add(Spoiler<Real, Phase::kick>{"spoiler"}, {world.find("second")});
  CHECK(failure_of(world).body == "second");
}

TEST_CASE_TEMPLATE("A push of one step that is too strong is told by the speed that it gives", Real,
                   EVERY_PRECISION) {
  World<Real> world(steps_per_second(1));
  world.step();
  const BodyHandle ball = world.add("ball", make_particle<Real>(Real(0.25)));
  world.push_at(ball, {0, most<Real>, 0}, {0, 0, 0});
  const SimulationError error = failure_of(world);
  CHECK(error.effect == "");
  CHECK(error.time == 1);
  CHECK(std::string(error.what())
            .find("'ball' at 1 s (step 1): with a velocity of (0, inf, 0) "
                  "m/s the step would lead to no finite position") == 0);
}

TEST_CASE_TEMPLATE("Whatever an effect writes that is no number is named with its unit", Real,
                   EVERY_PRECISION) {
  const auto said = [](const auto& effect) {
    World<Real> world;
    world.add("box", box_body<Real>({1, 2, 3}));
    world.add(effect, {world.find("box")});
    const std::string sentence = failure_of(world).what();
    const std::string begin = "'box' at 0 s (step 0): ",
                      end =
                          "; every component must be finite; the world is as it was before this "
                          "step";
    return sentence.find(begin) == 0 && sentence.size() > begin.size() + end.size() &&
                   sentence.substr(sentence.size() - end.size()) == end
               ? sentence.substr(begin.size(), sentence.size() - begin.size() - end.size())
               : sentence;
  };
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  CHECK(said(BadPlace<Real>{}) == "bad place gives a position of (0, inf, 0) m");
  CHECK(said(BadSpin<Real>{}) ==
        "bad spin gives an angular momentum of (0, 0, inf) kg m^2/s, body axes,");
  CHECK(said(BadFacing<Real>{{.real = nan, .imaginary = {1, 0, 0}}}) ==
        "bad facing gives an orientation that is no number");
  CHECK(said(BadFacing<Real>{{.real = 1, .imaginary = {0, nan, 0}}}) ==
        "bad facing gives an orientation that is no number");
}

TEST_CASE_TEMPLATE("What acts at the end of a step is blamed for what it does there", Real,
                   EVERY_PRECISION) {
  // A point that drifts, a ball that turns steadily and a box that tumbles; each alone trips it.
  World<Real> point(steps_per_second(1)), ball(steps_per_second(1)), box(steps_per_second(1));
  point.add("body", make_particle<Real>(1, {0, 0, 0}, {1, 0, 0}));
  const auto spinning = [](const Vec3<Real>& inverse_moments) {
    RigidBody<Real> body;
    body.centre = make_particle<Real>(1);
    body.top.inverse_moments = inverse_moments;
    body.top.angular_momentum_body = {1, Real(0.5), 0};
    return body;
  };
  ball.add("body", spinning({1, 1, 1}));
  box.add("body", spinning({1, 2, 3}));
  for (World<Real>* world : {&point, &ball, &box}) {
    world->add(Tripwire<Real>{}, {world->find("body")});
    CHECK(failure_of(*world).effect == "tripwire");
  }
}

TEST_CASE_TEMPLATE("A speed and a spin that lead too far are told as the kick has left them", Real,
                   EVERY_PRECISION) {
  World<Real> world(steps_per_second(1));
  world.add("ball", make_particle<Real>(1, {most<Real>, 0, 0}));
  world.add(Pull<Real>{"pull", {most<Real> / 4, 0, 0}});
  world.add(GravityAsAcceleration<Real>{{0, 0, -2}});
  CHECK(std::string(failure_of(world).what())
            .find("with a velocity of (" + text_of(most<Real> / 4) + ", 0, -2) m/s the step") !=
        std::string::npos);
  // What writes a velocity among the forces has done so once, too.
  World<Real> doubled(steps_per_second(1));
  doubled.add("ball", make_particle<Real>(1, {most<Real>, 0, 0}, {most<Real> / 16, 0, 0}));
  doubled.add(Doubler<Real>{});
  CHECK(std::string(failure_of(doubled).what())
            .find("with a velocity of (" + text_of(most<Real> / 8) + ", 0, 0) m/s the step") !=
        std::string::npos);
  World<Real> turning(steps_per_second(1));
  RigidBody<Real> body;
  body.top.inverse_moments = {1, 1, 1};
  const BodyHandle wheel = turning.add("wheel", body);
  const Real torque = 1 << 22;
  turning.push_at(wheel, {0, 0, torque}, {0, 1, 0});
  CHECK(std::string(failure_of(turning).what())
            .find("it would turn by " + text_of(torque) + " rad in this step") !=
        std::string::npos);
}

TEST_CASE_TEMPLATE("A joint that gives no number is named, with what it gave to the lost body",
                   Real, EVERY_PRECISION) {
  for (const bool force : {true, false}) {
    World<Real> world;
    world.add("bystander", box_body<Real>({9, 0, 0}));
    const BodyHandle a = world.add("a", box_body<Real>({0, 0, 0}));
    const BodyHandle b = world.add("b", box_body<Real>({3, 0, 0}));
    const BodyHandle c = world.add("c", box_body<Real>({6, 0, 0}));
    world.add(SpringBetween<Real>{.spring = {.stiffness = 1}}, {a, c});
    world.add(BrokenJoint<Real>{force}, {a, b});
    const std::string lost = force ? "'a' at 0 s (step 0): " : "'b' at 0 s (step 0): ";
    const std::string gave = force ? "a force of (0, nan, 0) N" : "a torque of (0, nan, 0) N m";
    CHECK(std::string(failure_of(world).what()).find(lost + "broken joint gives " + gave) == 0);
  }
}

TEST_CASE_TEMPLATE("The reference run stops where the run by plan does, and says the same", Real,
                   EVERY_PRECISION) {
  const auto complaint = [](bool by_plan) {
    World<Real> world;
    const BodyHandle a = world.add("a", box_body<Real>({0, 0, 0}));
    const BodyHandle b = world.add("b", box_body<Real>({3, 0, 0}));
    world.add(Gravity<Real>{.gravity = {0, 0, -1}});
    world.add(BrokenJoint<Real>{true}, {a, b});
    return std::string(
        failure_in([&] { by_plan ? world.step() : world.step_by_reference(); }).what());
  };
  CHECK(complaint(true).find("'a' at 0 s (step 0): broken joint gives ") == 0);
  CHECK(complaint(false) == complaint(true));
}

namespace {

/// Refuses to say how fast a body is.
template <class Real, Phase when>
struct Refusal {
  static constexpr Phase phase = when;
  static constexpr std::string_view name = "refusal";
  Vec3<Real> velocity(const Particle<Real>&, const StepTime<Real>&) const {
    throw std::domain_error("off the map");
  }
};

template <class Real>
bool same_motion(const World<Real>& one, const World<Real>& other) {
  const Snapshot<Real> a = one.save(), b = other.save();
  bool same = a.ticks == b.ticks;
  for (std::size_t body = 0; body < a.centres.size(); ++body)
    same = same && a.centres[body].position == b.centres[body].position &&
           a.centres[body].velocity == b.centres[body].velocity;
  for (std::size_t top = 0; top < a.tops.size(); ++top)
    same = same && a.tops[top].orientation.real == b.tops[top].orientation.real &&
           a.tops[top].orientation.imaginary == b.tops[top].orientation.imaginary &&
           a.tops[top].angular_momentum_body == b.tops[top].angular_momentum_body;
  return same;
}

}  // namespace

TEST_CASE_TEMPLATE("What an effect throws in the middle of a step comes through, and nothing moves",
                   Real, EVERY_PRECISION) {
  for (const Scheme scheme : {Scheme::semi_implicit_euler, Scheme::verlet, Scheme::suzuki}) {
    World<Real> world(steps_per_second(16));
    world.step_by(scheme);
    world.add("point", make_particle<Real>(1, {0, 0, 0}, {1, 0, 0}));
    RigidBody<Real> ball = box_body<Real>({3, 0, 0});
    ball.top.inverse_moments = {1, 1, 1};
    ball.top.angular_momentum_body = {0, 1, 0};
    world.add("ball", ball);
    const BodyHandle box = world.add("box", box_body<Real>({6, 0, 0}));
    world.add(Gravity<Real>{.gravity = {0, 0, -8}});
    world.add(Thruster<Real>{.force_body = {4, 0, 0}, .point = {0, 1, 1}}, {box});
    world.add(LinearDamping<Real>{.rate = 1});
    world.step();
    const auto refused = [&]<Phase when>(const Refusal<Real, when>& refusal) {
      World<Real> twin = world;
      const EffectHandle effect = world.add(refusal, {box});
      CHECK_THROWS_WITH_AS(world.step(), "off the map", std::domain_error);
      CHECK(same_motion(world, twin));
      world.remove(effect);
      world.step();  // with no force or torque from before in it
      twin.step();
      CHECK(same_motion(world, twin));
    };
    refused(Refusal<Real, Phase::force>{});
    refused(Refusal<Real, Phase::kick>{});
    refused(Refusal<Real, Phase::impulse>{});
    refused(Refusal<Real, Phase::damping>{});
    refused(Refusal<Real, Phase::drift>{});
  }
}
