#include <support/bench/our_world.hpp>
#include <support/bench/plain_loop.hpp>
#include <support/checks.hpp>
#ifdef TUMBLE_HAS_BULLET
#include <support/bench/bullet.hpp>
#endif
#ifdef TUMBLE_HAS_ODE
#include <support/bench/ode.hpp>
#endif

using namespace tumble;
using namespace tumble::support::bench;

namespace {

constexpr auto vector = vector_of<double>;

constexpr int seconds = 2;

template <class Bodies>
support::bench::Motion after_two_seconds(const Setting& setting, std::size_t n = 0) {
  Bodies bodies(setting);
  bodies.run(seconds * setting.rate);
  return bodies.motion(n);
}

/// Where gravity and damping bring a body: the solution of v' = g − k v.
support::bench::Motion exact_flight(const Start& start, double t) {
  const double k = damping_rate, kept = std::exp(-k * t), path = (1 - kept) / k;
  const Vec3d g(0, 0, gravity), v = vector(start.velocity);
  return {triple_of((vector(start.position) + path * v + (t - path) / k * g).eval()),
          triple_of((kept * v + path * g).eval()),
          {}};
}

/// Steps that kick and damp one after the other are off by |g| k h²/2 in
/// velocity in each step, and by h²/2 (|g| + k |v|) in position besides. Then
/// come the roundings, eight in a step.
template <class Bodies>
void check_flight(double unit_roundoff) {
  const Setting setting{.count = 3};
  const double h = setting.time_step(), t = seconds, k = damping_rate, g = -gravity;
  for (const std::size_t n : {std::size_t(0), std::size_t(2)}) {
    const Start start = start_of(n);
    const double fastest = vector(start.velocity).norm() + g * t;
    const double farthest = vector(start.position).norm() + fastest * t;
    const double roundings = 8 * t / h * unit_roundoff;
    const support::bench::Motion motion = after_two_seconds<Bodies>(setting, n),
                                 exact = exact_flight(start, t);
    CHECK((vector(motion.velocity) - vector(exact.velocity)).norm() <=
          t * h * g * k / 2 + roundings * fastest);
    CHECK((vector(motion.position) - vector(exact.position)).norm() <=
          t * h / 2 * (g + k * fastest + t * g * k) + roundings * farthest);
  }
}

/// The angular velocity after two seconds from steps so short that their error
/// does not show: of first order with torque, 64 times below that of the
/// others.
Vec3d true_spin(Scene scene) {
  return vector(
      after_two_seconds<OurWorld<double>>({.scene = scene, .rate = 480 * 64}).angular_velocity);
}

template <class Bodies>
double error_of_spin(Scene scene, int rate, bool gyroscopic = true) {
  const Setting setting{.scene = scene, .rate = rate, .gyroscopic = gyroscopic};
  return (vector(after_two_seconds<Bodies>(setting).angular_velocity) - true_spin(scene)).norm();
}

/// Halving the time step halves the error of a first-order rule and quarters
/// that of a second-order one, but for a tenth that higher orders and the
/// truth's own error may take.
template <class Bodies>
void check_order(Scene scene, int order) {
  const double ratio = error_of_spin<Bodies>(scene, 240) / error_of_spin<Bodies>(scene, 480);
  CHECK(ratio > 0.9 * std::pow(2, order));
  CHECK(ratio < 1.1 * std::pow(2, order));
}

/// Without the gyroscopic term no step is short enough.
template <class Bodies>
void check_turning() {
  check_order<Bodies>(Scene::tumbling, 1);
  check_order<Bodies>(Scene::everything, 1);
  const double off = error_of_spin<Bodies>(Scene::tumbling, 480, false);
  CHECK(error_of_spin<Bodies>(Scene::tumbling, 240, false) / off < 1.1);
  CHECK(error_of_spin<Bodies>(Scene::tumbling, 480) < off / 8);
}

}  // namespace

TEST_CASE_TEMPLATE("The plain loop takes our steps: its bodies are where the world's are", Real,
                   EVERY_PRECISION) {
  using Plain = PlainBodies<Real, Scene::everything, Rule::splitting>;
  const Setting setting{.count = 150, .threads = 2};
  const double steps = seconds * setting.rate;
  OurWorld<Real> world(setting);
  Plain plain(setting);
  world.run(static_cast<int>(steps));
  plain.run(static_cast<int>(steps));
  // A step rounds the spin some sixty times on its way through kick, damping
  // and three turns. What that changes in the phase is summed once more.
  const double roundings = 60 * steps * support::unit_roundoff<Real>;
  for (std::size_t n = 0; n < setting.count; ++n) {
    const support::bench::Motion ours = world.motion(n), its = plain.motion(n);
    const auto differ = [](const Triple& a, const Triple& b) {
      return (vector(a) - vector(b)).norm();
    };
    const double spin = vector(ours.angular_velocity).norm();
    REQUIRE(differ(ours.position, its.position) <= roundings * vector(ours.position).norm());
    REQUIRE(differ(ours.velocity, its.velocity) <= roundings * vector(ours.velocity).norm());
    REQUIRE(differ(ours.angular_velocity, its.angular_velocity) <=
            roundings * spin * (1 + spin * seconds));
  }
}

TEST_CASE_TEMPLATE("One body without a world tumbles as it does in the world, to the bit", Real,
                   EVERY_PRECISION) {
  const Setting setting{.scene = Scene::tumbling_with_torque};
  const support::bench::Motion bare = after_two_seconds<BareBody<Real>>(setting);
  for (const support::bench::Motion& world :
       {after_two_seconds<OurWorld<Real>>(setting),
        after_two_seconds<OurWorld<Real, OneByOne<Real>>>(setting)}) {
    CHECK(bare.position == world.position);
    CHECK(bare.velocity == world.velocity);
    CHECK(bare.angular_velocity == world.angular_velocity);
  }
}

TEST_CASE(
    "The plain loop's columns of any count start in different sets of "
    "the cache") {
  for (std::size_t bytes = 4; bytes < 10'000; bytes += 4)
    REQUIRE(column_stride(bytes, Spacing::padded) / cache_line % 2 == 1);
  CHECK(column_stride(1 << 16, Spacing::power_of_two) == 1 << 16);
}

TEST_CASE("The plain loop's turns without a sine are of second order too") {
  check_order<PlainBodies<double, Scene::tumbling, Rule::cayley>>(Scene::tumbling, 2);
}

TEST_CASE("The plain loop's explicit rule is of first order") {
  check_order<PlainBodies<double, Scene::tumbling, Rule::explicit_euler>>(Scene::tumbling, 1);
}

TEST_CASE_TEMPLATE("Our world's bodies fly as gravity and damping tell them", Real,
                   EVERY_PRECISION) {
  check_flight<OurWorld<Real>>(support::unit_roundoff<Real>);
}

#ifdef TUMBLE_HAS_BULLET
TEST_CASE(
    "Bullet's bodies fly as gravity and damping tell them, stepped by "
    "either way") {
  check_flight<BulletFunctions>(support::unit_roundoff<btScalar>);
  check_flight<BulletWorld>(support::unit_roundoff<btScalar>);
}

TEST_CASE(
    "Bullet's bodies turn as torque, damping and the gyroscopic term "
    "tell them; without it they don't") {
  check_turning<BulletFunctions>();
  check_turning<BulletWorld>();
}

TEST_CASE("Bullet's functions called one by one do what its world does") {
  const support::bench::Motion world = after_two_seconds<BulletWorld>({.count = 2}, 1);
  const support::bench::Motion functions = after_two_seconds<BulletFunctions>({.count = 2}, 1);
  const double roundings = 60 * seconds * 60 * support::unit_roundoff<btScalar>;
  CHECK((vector(world.position) - vector(functions.position)).norm() <=
        roundings * vector(world.position).norm());
  const double spin = vector(world.angular_velocity).norm();
  CHECK((vector(world.angular_velocity) - vector(functions.angular_velocity)).norm() <=
        roundings * spin * (1 + spin * seconds));
}
#endif

#ifdef TUMBLE_HAS_ODE
TEST_CASE("ODE's bodies fly as gravity and damping tell them") {
  check_flight<OdeWorld>(support::unit_roundoff<dReal>);
}

TEST_CASE(
    "ODE's bodies turn as torque, damping and the gyroscopic term tell "
    "them; without it they don't") {
  check_turning<OdeWorld>();
}
#endif
