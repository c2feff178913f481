// The lines of the books, with small whole numbers that round nothing, and their table.
#include <support/checks.hpp>
#include <support/size_of_line.hpp>
#include <tumble/gravity.hpp>
#include <tumble/springs.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

/// Multiplies a velocity and adds to it, m/s along x.
template <class Real, Phase when>
struct Change {
  static constexpr Phase phase = when;
  std::string name;
  Real factor, more;
  Vec3<Real> velocity(const Particle<Real>& centre, const StepTime<Real>&) const {
    return factor * centre.velocity + Vec3<Real>(more, 0, 0);
  }
};

}  // namespace

namespace {

/// A torque about the y axis, as long as the body is not below 1 m.
template <class Real>
struct Lift {
  static constexpr std::string_view name = "lift";
  Vec3<Real> torque(const Top<Real>&, Real) const { return {0, 2, 8}; }
};

/// What a body that has fallen to another height gets from an effect that acts at the end.
template <class Real>
struct Floor {
  static constexpr std::string_view name = "floor";
  static constexpr Phase phase = Phase::drift;
  Vec3<Real> velocity(const Particle<Real>& centre, const StepTime<Real>&) const {
    return centre.position.z() < 0 ? Vec3<Real>(0, 0, 0) : centre.velocity;
  }
};

}  // namespace

TEST_CASE_TEMPLATE(
    "What turns steadily about a locked axle carries its L along, and the books say so", Real,
    EVERY_PRECISION) {
  // Free about x and y, with moments 1 and 2, and locked about z: ω is not along L.
  RigidBody<Real> body;
  body.top.inverse_moments = {1, Real(0.5), 0};
  body.top.angular_momentum_body = {1, 2, 0};
  World<Real> world(steps_per_second(1));
  world.add("plate", body);
  world.add(Floor<Real>{});
  world.add(Lift<Real>{}, {world.find("plate")});
  Ledger<Real> ledger(world);
  ledger.step(world);
  std::vector<std::string> names;
  for (const LedgerLine& line : ledger.lines()) names.push_back(line.name);
  CHECK(names == std::vector<std::string>{"lift", "steady turning"});
  // Half a second's mean of ω_y = 1 and 2 times 2 N m; about z the axle bears it.
  CHECK(ledger.lines()[0].energy == 3);
  CHECK(same_bits(ledger.lines()[0].angular_momentum, Vec3d(0, 2, 0)));
  CHECK(ledger.lines()[1].angular_momentum.norm() > 1);
  CHECK(ledger.lines()[1].energy == 0);
  CHECK(size_of(ledger.rest(world)) <= 32 * 8 * static_cast<double>(unit_roundoff<Real>));
}

TEST_CASE_TEMPLATE("The books see what an effect at the end of a step sees: where the step has led",
                   Real, EVERY_PRECISION) {
  World<Real> world(steps_per_second(1));
  world.add("stone", make_particle<Real>(1, {0, 0, 4}));
  world.add(Floor<Real>{});
  world.add(Change<Real, Phase::kick>{"before", 1, 0});
  world.add(Gravity<Real>{{0, 0, -8}});
  Ledger<Real> ledger(world);
  ledger.step(world);  // it falls with 8 m/s to 4 m below the floor, and is stopped
  CHECK(ledger.lines()[0].name == "gravity");
  CHECK(ledger.lines()[0].energy == 32);
  CHECK(ledger.lines()[1].name == "before");
  CHECK(ledger.lines().back().name == "floor");
  CHECK(ledger.lines().back().energy == -32);
  CHECK(size_of(ledger.rest(world)) == 0);
}

TEST_CASE_TEMPLATE("Two springs and two weights store the sum of their energies", Real,
                   EVERY_PRECISION) {
  World<Real> world;
  const BodyHandle a = world.add("a", make_particle<Real>(1, {0, 0, 1}));
  const BodyHandle b = world.add("b", make_particle<Real>(2, {0, 0, 4}));
  const BodyHandle c = world.add("c", make_particle<Real>(4, {0, 0, 8}));
  world.add(Gravity<Real>{.gravity = {0, 0, -2}}, {a, b});
  world.add(SpringBetween<Real>{.spring = {.stiffness = 2, .rest_length = 1}}, {a, b, b, c});
  // m g z of two: 2 + 16; k s²/2 of stretches 2 and 3: 4 + 9. Small whole numbers round nothing.
  CHECK(stored_energy(world) == 31);
}

TEST_CASE_TEMPLATE("At a turning point of a swing nobody is told that steps were too long", Real,
                   EVERY_PRECISION) {
  World<Real> world(steps_per_second(100));
  world.add("weight", make_particle<Real>(1, {1, 0, 0}));
  world.add(SpringToPoint<Real>{.spring = {.stiffness = 1}});  // w h = 0.01; half a swing: 3.14 s
  Ledger<Real> ledger(world);
  while (world.time() < Real(3.1)) ledger.step(world);
  CHECK(ledger.now(world).energy < 0.01 * ledger.largest_kinetic());
  CHECK(energies_of(ledger, world).find("too long") == std::string::npos);
  // With w h = 0.5 it would swing by half of it.
  World<Real> rough(steps_per_second(2));
  rough.add("weight", make_particle<Real>(1, {1, 0, 0}));
  rough.add(SpringToPoint<Real>{.spring = {.stiffness = 1}});
  Ledger<Real> its(rough);
  for (int n = 0; n < 14; ++n) its.step(rough);
  CHECK(energies_of(its, rough).find("too long") != std::string::npos);
}

TEST_CASE("Plans and books are tables whose columns are in line") {
  World<double> world(steps_per_second(2));
  world.add("stone", make_particle<double>(2, {1, 0, 8}));
  world.add("wall", make_static_particle<double>({0, 0, 0}));
  world.add(Gravity<double>{.gravity = {0, 0, -4}});
  CHECK(table_of(world.plan()) ==
        R"(effect               phase    bodies  reads                writes             why
gravity              force    1 of 2  mass                 force              not 1: nothing can move them
kick                 kick     1 of 2  mass, force          velocity           not 1: nothing can move them
drift                drift    1 of 2  velocity             position           not 1: nothing can move them
kick of the spin     no pass  0 of 2  orientation, torque  spin               not 2: points do not turn
steady turning       no pass  0 of 2  spin                 orientation        not 2: points do not turn
tumbling: splitting  no pass  0 of 2  spin                 orientation, spin  not 2: points do not turn
order 1: semi-implicit Euler
)");
  Ledger<double> ledger(world);
  ledger.step(world);
  // Half a second of 8 N: -4 N s at a mean speed of -1 m/s, and 1 m beside the origin.
  CHECK(table_of(ledger, world) ==
        R"(              energy, J  momentum x, y, z, kg m/s      angular momentum x, y, z, kg m^2/s
at the start          0          0         0         0          0         0         0
+ gravity             4          0         0        -4          0         4         0
+ drift               0          0         0         0          0         0         0
now                   4          0         0        -4          0         4         0
unexplained           0          0         0         0          0         0         0
kinetic + stored = sum, J: 0 + 64 = 64 at the start, 4 + 56 = 60 now
no effect takes or gives energy, but the sum has changed by more than a tenth of the largest kinetic energy: steps were too long for a force
)");
  // Sixteen such steps lose a sixteenth of the kinetic energy; and a damper may take what it likes.
  for (int n = 0; n < 15; ++n) ledger.step(world);
  CHECK(energies_of(ledger, world) ==
        "kinetic + stored = sum, J: 0 + 64 = 64 at the start, 1024 + -1024 = 0 now\n");
  world.add(SpringToPoint<double>{.spring = {.stiffness = 1, .damping = 1}}, {world.find("stone")});
  ledger.step(world);
  CHECK(energies_of(ledger, world).find("too long") == std::string::npos);
}
