#include <support/checks.hpp>
#include <tumble/embedded_steps.hpp>
#include <tumble/lie_runge_kutta.hpp>
#include <tumble/reduced_steps.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

/// A weight on the axis that comes and goes with time, and perhaps a field across, as of a magnet.
struct ChangingWeight {
  double field = 0;
  void operator()(Topd& top, double time) const {
    top.torque = torque_on_axis(rotate<double>(top.orientation, Vec3d::UnitZ()), time);
  }
  Vec3d torque_on_axis(const Vec3d& axis, double time) const {
    return (2 + std::sin(3 * time)) * Vec3d(-axis.y(), axis.x(), 0) +
           field * axis.cross(Vec3d::UnitX());
  }
};

/// A torque that changes with time along all three axes of the world.
struct Motor {
  void operator()(Topd& top, double time) const {
    top.torque = {std::sin(2 * time), std::cos(3 * time), time};
  }
};

Topd symmetric_top() {
  Topd top;
  top.inverse_moments = {1, 1, 2};
  top.orientation = quaternion_of_rotation_vector(Vec3d(0.5, -0.25, 1));
  set_angular_velocity_body<double>(top, {0.5, -1, 4});
  return top;
}

Topd lopsided_top() {
  Topd top = symmetric_top();
  top.inverse_moments = {1, 0.5, 0.25};
  return top;
}

void check_same(const Topd& found, const Topd& truth, double most) {
  CHECK(angle_between(found.orientation, truth.orientation) <= most);
  CHECK(distance(found.angular_momentum_body, truth.angular_momentum_body) <=
        most * truth.angular_momentum_body.norm());
}

}  // namespace

TEST_CASE(
    "Under a weight that changes with time, an axis apart from its spin moves as the whole top") {
  // Two algorithms: six unknowns and an integral, and all seven numbers. Both may lose 1e-11 in a
  // second; a turn under this weight spreads errors tenfold at most in two.
  for (const double field : {0.0, 0.5}) {
    Topd whole = symmetric_top(), apart = whole, evenly = whole;
    const ChangingWeight weight{field};
    weight(whole, 2.0);
    integrate<DormandPrince853>(whole, weight, 2.0, 1.75, 1e-11);
    integrate_axis<DormandPrince853>(apart, weight, 2.0, 1.75, 1e-11);
    integrate_axis_evenly<DormandPrinceEighth>(evenly, weight, 2.0, 1.75, 256);
    check_same(apart, whole, 1e-9);
    check_same(evenly, whole, 1e-9);
    Topd last = whole;
    weight(last, 3.75);
    for (const Topd& top : {whole, apart, evenly}) CHECK(distance(top.torque, last.torque) <= 1e-8);
  }

  Topd top = symmetric_top();
  const ChangingWeight weight;
  CHECK_NOTHROW(integrate_axis_evenly<Kutta>(top, weight, 0.0, 1e-3, 1));
  CHECK(complaint_of([&] { integrate_axis<DormandPrince54>(top, weight, 0.0, -1, 1e-3); }) ==
        "time is -1 s; it must be 0 or more");
  CHECK(complaint_of([&] {
          integrate_axis<DormandPrince54>(top, weight, 0.0, 1, 0);
        }).find("tolerance is 0") == 0);
}

TEST_CASE(
    "An axis that swings right through the one it is measured from is followed all the same") {
  // Half a turn and more about x, from upright to hanging and up on the other side.
  Topd whole = symmetric_top();
  whole.orientation = {};
  set_angular_velocity_body<double>(whole, {4, 0.5, 1});
  Topd apart = whole, evenly = whole;
  const ChangingWeight weight;
  weight(whole, 0.0);
  integrate<DormandPrince853>(whole, weight, 0.0, 1.5, 1e-11);
  integrate_axis<DormandPrince853>(apart, weight, 0.0, 1.5, 1e-11);
  integrate_axis_evenly<DormandPrinceEighth>(evenly, weight, 0.0, 1.5, 512);
  check_same(apart, whole, 1e-9);
  check_same(evenly, whole, 1e-9);
}

TEST_CASE("Once an axis has gone too far, the next step is the first of a new integration") {
  const ChangingWeight weight;
  const double h = 1.0 / 8;  // so that times are exact
  Topd start = symmetric_top();
  start.orientation = {};
  set_angular_velocity_body<double>(start, {4, 0.5, 1});

  // Steps that are chosen err by as much as those that start anew.
  using Motion = AxisTurn<ChangingWeight, double>;
  using Steps = ReducedSteps<DormandPrince853, Motion, double>;
  Steps steps(Motion(start, weight), 0, 1);
  Topd top = start;
  long count = 0;
  for (; rotate<double>(top.orientation, Vec3d::UnitZ()).z() >= -0.5; ++count) {
    steps.attempt(h);
    steps.accept();
    top = steps.body();
  }
  const double begin = static_cast<double>(count) * h;
  Steps anew(Motion(top, weight), begin, 1);
  // h rad are allowed. An error sums up what 13 stages change in h: less than 1 each, rounded some
  // 16 times.
  CHECK(std::abs(std::sqrt(steps.attempt(h)) - std::sqrt(anew.attempt(h))) * h <=
        13 * 16 * unit_roundoff<double>);

  // Even steps lead to the same place in one integration as in two, to 64 roundings as where one
  // starts anew on the way, of which a step makes less than twice as many.
  Topd in_one = start, in_two = start;
  integrate_axis_evenly<Kutta>(in_one, weight, 0.0, begin + h, count + 1);
  integrate_axis_evenly<Kutta>(in_two, weight, 0.0, begin, count);
  integrate_axis_evenly<Kutta>(in_two, weight, begin, h, 1);
  check_same(in_one, in_two, 2 * 64 * unit_roundoff<double>);
}

TEST_CASE("Which axis is that of symmetry is found, and a top without one is refused") {
  for (int axis = 0; axis < 3; ++axis) {
    Topd top = symmetric_top();
    top.inverse_moments = {1, 1, 1};
    top.inverse_moments[axis] = 2;
    const AxisTurn<ChangingWeight, double> motion(top, ChangingWeight{});
    const auto y = motion.state();
    const Vec3d c = rotate<double>(top.orientation, Vec3d::Unit(axis));
    CHECK(distance(Vec3d(y[0], y[1], y[2]), c) <= 8 * unit_roundoff<double>);
    CHECK(distance(Vec3d(y[3], y[4], y[5]), angular_momentum_world(top)) <=
          32 * unit_roundoff<double> * angular_momentum_world(top).norm());
  }
  Topd locked = symmetric_top();
  locked.inverse_moments = {0, 0, 1};
  CHECK(complaint_of([&] {
          AxisTurn<ChangingWeight, double>(locked, ChangingWeight{});
        }).find("two of them must be equal, and none 0") != std::string::npos);
}

TEST_CASE("An error of an axis and of its momentum count as an angle and as a part") {
  const AxisTurn<ChangingWeight, double> motion(symmetric_top(), ChangingWeight{});
  CHECK(motion.square({2, 3, 6, 3, 4, 12}, {1, 0, 0, 1, 4, 8}) == 49 + 169 / 81.0);
  CHECK(motion.square({2, 3, 6, 0, 0, 0}, {1, 0, 0, 0, 0, 0}) == 49);
  CHECK(motion.square({0, 0, 0, 1, 0, 0}, {1, 0, 0, 0, 2, 0}) == 0.25);
  const FreeTurn<double> free(lopsided_top());
  CHECK(free.square({2, 3, 6}, {1, 0, 0}) == 49);
}

TEST_CASE("L is measured from the axis that it goes around, on its own side") {
  // Inverse moments 1, 1/2, 1/4: with much energy for its |L| it goes around x, with little around
  // z.
  for (const double side : {1.0, -1.0}) {
    Topd top = lopsided_top();
    const auto far = [&](const Vec3d& L, const StateVector<double, 3>& l) {
      top.angular_momentum_body = side * L;
      return FreeTurn<double>(top).is_far({side * l[0], side * l[1], side * l[2]});
    };
    CHECK(far({3, 1, 1}, {-0.6, 0.8, 0}));
    CHECK_FALSE(far({3, 1, 1}, {-0.4, 0, 0.9}));
    CHECK_FALSE(far({3, 1, 1}, {0.6, 0, -0.8}));
    CHECK(far({1, 1, 3}, {0, 0.8, -0.6}));
    CHECK_FALSE(far({1, 1, 3}, {-0.9, 0, -0.4}));
    // Of two equal moments, the axis nearer to L.
    top.inverse_moments = {1, 0.25, 0.25};
    CHECK(far({0, 0, 3}, {0, 0.8, -0.6}));
    CHECK_FALSE(far({0, 0, 3}, {0, -0.8, 0.6}));
    CHECK(far({0, 3, 0}, {0, -0.8, 0.6}));
    CHECK_FALSE(far({0, 3, 0}, {0, 0.8, -0.6}));
    const AxisTurn<ChangingWeight, double> axis(
        [&] {
          Topd tilted = symmetric_top();
          tilted.orientation = quaternion_of_rotation_vector(Vec3d(side > 0 ? 0.5 : 2.5, 0, 0));
          return tilted;
        }(),
        ChangingWeight{});
    CHECK(axis.is_far({0.8, 0, -0.6 * side, 0, 0, 0}));
    CHECK_FALSE(axis.is_far({0, 0.9, -0.4 * side, 0, 0, 0}));
    CHECK_FALSE(axis.is_far({0, -0.8, 0.6 * side, 0, 0, 0}));
  }
}

TEST_CASE("To start anew on the way changes nothing of the motion") {
  FreeTurn<double> free(lopsided_top());
  const StateVector<double, 3> l = {0.48, 0.6, 0.64};
  const Topd before = free.top_at(l, 0.75);
  free.change_chart(l, 0.75);
  check_same(free.top_at(free.state(), 0), before, 64 * unit_roundoff<double>);
  CHECK(distance(Vec3d(free.state()[0], free.state()[1], free.state()[2]),
                 Vec3d(l[0], l[1], l[2])) <= 8 * unit_roundoff<double>);
}

TEST_CASE("Lie's Runge-Kutta rule follows a motor as the classical one does, whenever it begins") {
  const Motor motor;
  for (const double begin : {0.0, 2.0}) {
    Topd lie = lopsided_top();
    motor(lie, begin);
    Topd classical = lie;
    const double h = 1.0 / 256;
    for (int n = 0; n < 256; ++n) {
      turn_by_lie_runge_kutta(lie, motor, begin + n * h, h);
      step_by_runge_kutta<Kutta>(classical, motor, begin + n * h, h);
    }
    // Both are of fourth order: at 4 rad/s, 1/64 rad a step, some (1/64)^4 = 6e-8 in all.
    check_same(lie, classical, 1e-6);
    CHECK(distance(lie.torque, classical.torque) <= 8 * unit_roundoff<double> * lie.torque.norm());
    CHECK(std::abs(norm(lie.orientation) - 1) <= 8 * unit_roundoff<double>);
  }
}

TEST_CASE("The rates under a torque are Euler's equations in body axes") {
  Topd top = lopsided_top();
  top.torque = {3, -5, 7};
  const auto rates = rates_of(state_of(top), top);
  const Vec3d expected = rotate_back<double>(top.orientation, top.torque) + gyroscopic_torque(top);
  CHECK(distance(Vec3d(rates[4], rates[5], rates[6]), expected) <=
        32 * unit_roundoff<double> * expected.norm());
  for (int axis = 0; axis < 3; ++axis) {
    Topd locked = top;
    locked.inverse_moments[axis] = 0;
    locked.angular_momentum_body[axis] = 0;
    CHECK(rates_of(state_of(locked), locked)[static_cast<std::size_t>(4 + axis)] == 0);
  }
}

TEST_CASE("Without torque the integrations of free tops turn as the steps do, steadily too") {
  Topd ball = lopsided_top();
  ball.inverse_moments = {1, 1, 1};
  Topd steady = ball;
  CHECK(integrate_free_top<DormandPrince54>(ball, 1.5, 1e-3).steps == 1);
  turn_steadily(steady, 1.5);
  check_same(ball, steady, 32 * unit_roundoff<double>);
  Topd spun = lopsided_top();
  spun.angular_momentum_body = {0, 0, 1};
  steady = spun;
  integrate_free_top<DormandPrince54>(spun, 1.5, 1e-3);
  turn_steadily(steady, 1.5);
  check_same(spun, steady, 32 * unit_roundoff<double>);
}
