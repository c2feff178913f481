// The symmetries of the physics, in a whole world.
#include <support/checks.hpp>
#include <support/symmetric_scene.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

template <class Real>
bool is_same(const RigidBody<Real>& a, const RigidBody<Real>& b) {
  return same_bits(a.centre.position, b.centre.position) &&
         same_bits(a.centre.velocity, b.centre.velocity) &&
         same_bits(a.top.orientation, b.top.orientation) &&
         same_bits(a.top.angular_momentum_body, b.top.angular_momentum_body);
}

template <class Real>
std::array<RigidBody<Real>, 2> bodies_of(World<Real>& world) {
  return {world.body(world.find("first")), world.body(world.find("second"))};
}

}  // namespace

TEST_CASE_TEMPLATE("A world that is turned as a whole takes the same step, to rounding", Real,
                   EVERY_PRECISION) {
  std::mt19937_64 generator(142);
  for (int trial = 0; trial < 20; ++trial) {
    const RigidBody<Real> first = random_brick<Real>(generator),
                          second = random_brick<Real>(generator);
    TurnedFrame<Real> frame;
    frame.turn = random_orientation<Real>(generator);
    World<Real> plain = scene_with(first, second, SameFrame<Real>{});
    World<Real> turned = scene_with(first, second, frame);
    plain.step();
    turned.step();
    // Nothing is larger than 10, and no vector is turned more than eight times on its way: by the
    // test, to its attachment, into the body, as its torque, and back.
    const Real bound = 8 * 10 * rotation_error<Real>;
    const auto before = bodies_of(plain), after = bodies_of(turned);
    for (std::size_t n = 0; n < 2; ++n) {
      const RigidBody<Real> expected = seen(before[n], frame);
      CHECK(distance(after[n].centre.position, expected.centre.position) <= bound);
      CHECK(distance(after[n].centre.velocity, expected.centre.velocity) <= bound);
      CHECK(angle_between(after[n].top.orientation, expected.top.orientation) <= bound);
      CHECK(distance(after[n].top.angular_momentum_body, expected.top.angular_momentum_body) <=
            bound);
    }
  }
}

TEST_CASE_TEMPLATE("A world in a mirror moves the mirrored way, to the bit", Real,
                   EVERY_PRECISION) {
  std::mt19937_64 generator(143);
  const RigidBody<Real> first = random_brick<Real>(generator),
                        second = random_brick<Real>(generator);
  World<Real> plain = scene_with(first, second, SameFrame<Real>{});
  for (int n = 0; n < 100; ++n) plain.step();
  for (int axis = 0; axis < 3; ++axis) {
    const MirroredFrame<Real> frame{axis};
    World<Real> mirrored = scene_with(first, second, frame);
    for (int n = 0; n < 100; ++n) mirrored.step();
    for (std::size_t n = 0; n < 2; ++n)
      CHECK(is_same(bodies_of(mirrored)[n], seen(bodies_of(plain)[n], frame)));
  }
}

TEST_CASE_TEMPLATE("A world a trillion times as heavy or as light moves the same, to the bit", Real,
                   EVERY_PRECISION) {
  std::mt19937_64 generator(144);
  const RigidBody<Real> first = random_brick<Real>(generator),
                        second = random_brick<Real>(generator);
  const SameFrame<Real> frame;
  World<Real> plain = scene_with(first, second, frame);
  for (int n = 0; n < 100; ++n) plain.step();
  for (const int exponent : {-40, -13, 7, 40}) {
    CAPTURE(exponent);
    const Real scale = std::ldexp(Real(1), exponent);
    World<Real> scaled = scene_with(first, second, frame, scale);
    for (int n = 0; n < 100; ++n) scaled.step();
    for (std::size_t n = 0; n < 2; ++n)
      CHECK(is_same(bodies_of(scaled)[n], seen(bodies_of(plain)[n], frame, scale)));
  }
}

TEST_CASE_TEMPLATE("A world leaves the processor's small numbers alone", Real, EVERY_PRECISION) {
  std::mt19937_64 generator(145);
  World<Real> world =
      scene_with(random_brick<Real>(generator), random_brick<Real>(generator), SameFrame<Real>{});
  world.step();
  volatile Real smallest = std::numeric_limits<Real>::min();  // else the compiler divides
  CHECK(smallest / 2 > 0);
}
