#include <span>
#include <support/body_bounds.hpp>
#include <support/rules.hpp>
#include <vector>

using namespace tumble;
using namespace tumble::support;

namespace {

/// The rule that the chapter chose.
template <class Real>
constexpr auto chosen_rule = [](Top<Real>& top, Real time_step) { drift(top, time_step); };

/// Three roundings of each component of a product of quaternions, thrice, and as many for the norm.
template <class Real>
constexpr Real turn_error = 40 * unit_roundoff<Real>;

}  // namespace

TEST_CASE(
    "The thin rod at 60 steps a second: energy within 10⁻⁴, L within 10⁻¹⁰, phase within 10⁻³") {
  const Motion motion = watched<double>(tumbling_problems[2], chosen_rule<double>);
  CHECK(motion.diverged == 0);
  CHECK(motion.energy_error < 1e-4);
  CHECK(motion.momentum_error < 1e-10);
  CHECK(motion.angle < 1e-3);
  const Motion in_float = watched<float>(tumbling_problems[2], chosen_rule<float>);
  CHECK(in_float.diverged == 0);
  CHECK(in_float.energy_error < 1e-4);
  CHECK(in_float.momentum_error < 1e-4);
}

TEST_CASE_TEMPLATE(
    "The needle of 1 to a million: finite, and the energy within 10⁻⁴ for 3600 steps", Real, float,
    double) {
  const Motion motion = watched<Real>(tumbling_problems[3], chosen_rule<Real>);
  CHECK(motion.diverged == 0);
  CHECK(motion.energy_error < 1e-4);
}

TEST_CASE_TEMPLATE("A symmetric top is turned exactly, however long the step", Real, float,
                   double) {
  // The last one is so nearly round that only a difference of the inverse moments themselves keeps
  // the digits of what its axes do.
  const Real nearly = Real(1.0013);
  for (const auto& [h, inverse] :
       {std::pair(Real(0.01), Vec3<Real>(Real(0.5), Real(0.5), Real(0.25))),
        std::pair(Real(0.5), Vec3<Real>(Real(0.5), Real(0.5), Real(0.25))),
        std::pair(Real(3), Vec3<Real>(Real(0.5), Real(0.5), Real(0.25))),
        std::pair(Real(20), Vec3<Real>(Real(0.5), Real(0.5), Real(0.25))),
        std::pair(Real(256), Vec3<Real>(nearly, nearly, 1))}) {
    Top<Real> top{.orientation = normalized(Quaternion<Real>{1, {2, -3, 4}}),
                  .inverse_moments = inverse};
    set_angular_velocity_body(top, Vec3<Real>(Real(0.5), 1, 2));
    const auto there = exact::FreeTop<long double>(exactly(top)).at(h);
    turn_by_splitting(top, h);
    // The angles asked for are up to h |L|/I and rounded twice; then the turns.
    const Real bound = 4 * unit_roundoff<Real> * h * 10 + 2 * turn_error<Real>;
    CHECK(static_cast<Real>(angle_between(there.orientation, exactly(top).orientation)) <= bound);
    const Vec3<Real> w = angular_velocity_body(there).template cast<Real>();
    CHECK(distance(angular_velocity_body(top), w) <= 3 * bound);
    // L goes round the axis by h L₃ times the difference, which rounds by that much alone.
    const Real round = h * 2 * std::abs(inverse.z() - inverse.x()) / inverse.z();
    const Vec3<Real> L = there.angular_momentum_body.template cast<Real>();
    CHECK(distance(top.angular_momentum_body, L) <=
          (8 * round + 20) * unit_roundoff<Real> * L.norm());
  }
}

TEST_CASE_TEMPLATE("A step turns up to the sine's limit, and a needle beyond it if L is across",
                   Real, EVERY_PRECISION) {
  const Real limit = 2 * SineCosineConstants<Real>::limit;
  const auto answered = [](const Vec3<Real>& inverse_moments, const Vec3<Real>& L) {
    Top<Real> top{.angular_momentum_body = L, .inverse_moments = inverse_moments};
    drift(top, 1);
    return std::isfinite(top.orientation.real);
  };
  const Real thin = Real(1) / 1024;
  const Vec3<Real> x = Vec3<Real>::UnitX(), y = Vec3<Real>::UnitY(), z = Vec3<Real>::UnitZ();
  for (const Vec3<Real>& inverse : {Vec3<Real>(thin, thin, 1), Vec3<Real>(1, Real(0.9), thin),
                                    Vec3<Real>(1, Real(0.5), Real(0.25)), Vec3<Real>(1, 1, 1)})
    for (const Vec3<Real>& direction : {x, y, z, Vec3<Real>((x - y + z).normalized())}) {
      CHECK(answered(inverse, Real(0.999) * limit * direction));
      const bool turns_beyond = Real(1.5) * inverse.cwiseProduct(direction).norm() > 1;
      if (turns_beyond) CHECK_FALSE(answered(inverse, Real(1.5) * limit * direction));
    }
  CHECK(answered({thin, thin, 1}, Real(1.5) * limit * y));
  CHECK_FALSE(answered({thin, thin, 1}, Real(1.5) * limit * z));
}

TEST_CASE_TEMPLATE(
    "A ball needs none of it: every rule turns it steadily, and the default skips the work", Real,
    EVERY_PRECISION) {
  Top<Real> ball{.orientation = normalized(Quaternion<Real>{1, {2, -3, 4}}),
                 .inverse_moments = Vec3<Real>(4, 4, 4)};
  set_angular_velocity_body(ball, Vec3<Real>(1, 2, 3));
  CHECK(!is_gyroscopic(ball));
  CHECK(same_bits(gyroscopic_torque(ball), Vec3<Real>::Zero()));
  Top<Real> steady = ball, chosen = ball;
  turn_steadily(steady, Real(0.3));
  drift(chosen, Real(0.3));
  CHECK(chosen.orientation.real == steady.orientation.real);
  CHECK(same_bits(chosen.orientation.imaginary, steady.orientation.imaginary));
  for (const Rule<Real>& rule : rules<Real>) {
    CAPTURE(std::string(rule.name));
    if (rule.turn == turn_axis_by_axis<Real>) continue;  // cuts even a ball's turn in three
    Top<Real> other = ball;
    rule.turn(other, Real(0.3));
    CHECK(angle_between(other.orientation, steady.orientation) <= turn_error<Real>);
    CHECK(distance(other.angular_momentum_body, ball.angular_momentum_body) <= turn_error<Real>);
  }
}

TEST_CASE_TEMPLATE("Only unequal moments about three free axes are gyroscopic", Real,
                   EVERY_PRECISION) {
  const auto gyroscopic = [](Real a, Real b, Real c) {
    return is_gyroscopic(Top<Real>{.inverse_moments = Vec3<Real>(a, b, c)});
  };
  // However little one of them differs, and whichever it is.
  for (const Real other : {Real(2), 1 + std::numeric_limits<Real>::epsilon()}) {
    CHECK(gyroscopic(1, 1, other));
    CHECK(gyroscopic(1, other, 1));
    CHECK(gyroscopic(other, 1, 1));
  }
  CHECK(!gyroscopic(2, 2, 2));
  CHECK(!gyroscopic(0, 1, 2));
  CHECK(!gyroscopic(1, 0, 2));
  CHECK(!gyroscopic(1, 1, 0));
  CHECK(!gyroscopic(0, 0, 0));
}

TEST_CASE_TEMPLATE(
    "A top with a locked axis keeps its spin in the body, and a locked one stands still", Real,
    EVERY_PRECISION) {
  Top<Real> rod{.angular_momentum_body = Vec3<Real>(1, 2, 0),
                .inverse_moments = Vec3<Real>(1, 3, 0)};
  const Vec3<Real> turn = Real(0.25) * angular_velocity_body(rod);
  // L × ω is not zero, but it lies along the locked axis: what locks it bears it.
  CHECK(same_bits(gyroscopic_torque(rod), Vec3<Real>(0, 0, 4)));
  CHECK(same_bits(free_part(rod, gyroscopic_torque(rod)), Vec3<Real>::Zero()));
  drift(rod, Real(0.25));
  CHECK(same_bits(rod.angular_momentum_body, Vec3<Real>(1, 2, 0)));
  CHECK(angle_between(rod.orientation, quaternion_of_rotation_vector(turn)) <= turn_error<Real>);
  Top<Real> wall{.torque = Vec3<Real>(1, 2, 3)};
  kick(wall, Real(0.25));
  drift(wall, Real(0.25));
  CHECK(same_bits(wall.orientation.imaginary, Vec3<Real>::Zero()));
  CHECK(same_bits(wall.angular_momentum_body, Vec3<Real>::Zero()));
}

TEST_CASE_TEMPLATE("A kick changes L in the world by the torque times the time step", Real,
                   EVERY_PRECISION) {
  std::mt19937_64 generator(81);
  for (int trial = 0; trial < 100; ++trial) {
    Top<Real> top = random_brick<Real>(generator).top;
    const Vec3<Real> before = angular_momentum_world(top), torque = random_vector<Real>(generator);
    add_torque(top, torque);
    kick(top, Real(0.125));
    CHECK(distance<Real>(angular_momentum_world(top), before + Real(0.125) * torque) <=
          3 * rotation_error<Real> * (before.norm() + torque.norm()));
  }
}

TEST_CASE_TEMPLATE("A body is kicked and drifts as its particle and its top do", Real,
                   EVERY_PRECISION) {
  std::mt19937_64 generator(84);
  RigidBody<Real> body = random_brick<Real>(generator);
  add_force_at(body, Vec3<Real>(1, 2, 3), Vec3<Real>(4, 5, 6));
  Particle<Real> centre = body.centre;
  Top<Real> top = body.top;
  kick(body, Real(0.125));
  drift(body, Real(0.125));
  step(centre, Real(0.125));
  kick(top, Real(0.125));
  drift(top, Real(0.125));
  CHECK(same_bits(body.centre.position, centre.position));
  CHECK(same_bits(body.centre.velocity, centre.velocity));
  CHECK(same_bits(body.top.orientation, top.orientation));
  CHECK(same_bits(body.top.angular_momentum_body, top.angular_momentum_body));
}

TEST_CASE_TEMPLATE("A turn about one axis is the quaternion's turn, and leaves L in the world",
                   Real, EVERY_PRECISION) {
  std::mt19937_64 generator(82);
  for (int trial = 0; trial < 100; ++trial) {
    const Top<Real> start = random_brick<Real>(generator).top;
    const Real angle = 4 * random_number<Real>(generator);
    const auto check = [&](const Top<Real>& turned, int axis) {
      const Quaternion<Real> expected =
          start.orientation * quaternion_about<Real>(Vec3<Real>::Unit(axis), angle);
      CHECK(distance(turned.orientation, expected) <= turn_error<Real>);
      CHECK(distance<Real>(angular_momentum_world(turned), angular_momentum_world(start)) <=
            3 * rotation_error<Real> * start.angular_momentum_body.norm());
    };
    Top<Real> x = start, y = start, z = start;
    turn_about_axis<0>(x, angle);
    turn_about_axis<1>(y, angle);
    turn_about_axis<2>(z, angle);
    check(x, 0);
    check(y, 1);
    check(z, 2);
  }
}

TEST_CASE_TEMPLATE("Turn the scene, step, turn back: the body can't tell, to the bit", Real, float,
                   double) {
  std::mt19937_64 generator(83);
  for (const TumblingProblem& problem : tumbling_problems)
    for (const Rule<Real>& rule : rules<Real>) {
      CAPTURE(std::string(rule.name));
      const Quaternion<Real> scene = random_orientation<Real>(generator);
      Top<Real> plain = top_of<Real>(problem), turned = plain;
      turned.orientation = scene * plain.orientation;
      rule.turn(plain, Real(1) / 60);
      rule.turn(turned, Real(1) / 60);
      CHECK(same_bits(turned.angular_momentum_body, plain.angular_momentum_body));
      CHECK(angle_between(turned.orientation, scene * plain.orientation) <= 3 * turn_error<Real>);
    }
}

TEST_CASE_TEMPLATE("Moments and momentum scaled by the same power of two turn the same, to the bit",
                   Real, float, double) {
  const auto flown = [](const TumblingProblem& problem, const Rule<Real>& rule, Real scale) {
    Top<Real> top = top_of<Real>(problem);
    top.torque = top.angular_momentum_body.norm() * Vec3<Real>(Real(0.1), Real(-0.2), Real(0.3));
    top.inverse_moments /= scale;
    top.angular_momentum_body *= scale;
    top.torque *= scale;
    for (int n = 0; n < 8; ++n) {
      kick(top, Real(1) / 60);
      rule.turn(top, Real(1) / 60);
    }
    top.angular_momentum_body /= scale;
    return top;
  };
  // Squares of L are the furthest that the rules go. In float they keep all digits while each
  // component lies between 2^-62 and 2^63; with L from 2^-13 to 9, 2^±40 is well inside.
  for (const TumblingProblem& problem : tumbling_problems) {
    const Vec3<Real> L = top_of<Real>(problem).angular_momentum_body.cwiseAbs();
    CHECK(L.minCoeff() > std::ldexp(Real(1), -13));
    CHECK(L.maxCoeff() <= 9);
  }
  for (const TumblingProblem& problem : std::span(tumbling_problems).first(3))
    for (const Rule<Real>& rule : rules<Real>)
      for (const int exponent : {-40, -13, 7, 40}) {
        CAPTURE(std::string(rule.name));
        CAPTURE(exponent);
        const Top<Real> plain = flown(problem, rule, 1);
        const Top<Real> scaled = flown(problem, rule, std::ldexp(Real(1), exponent));
        CHECK(same_bits(scaled.orientation, plain.orientation));
        CHECK(same_bits(scaled.angular_momentum_body, plain.angular_momentum_body));
      }
}

TEST_CASE_TEMPLATE("A top seen in a mirror turns the mirrored way, to the bit", Real, float,
                   double) {
  for (const TumblingProblem& problem : tumbling_problems)
    for (const Rule<Real>& rule : rules<Real>)
      for (int axis = 0; axis < 3; ++axis) {
        CAPTURE(std::string(rule.name));
        // Turns mirror as torques do: the part along the mirrored axis keeps its sign.
        Vec3<Real> sign(-1, -1, -1);
        sign[axis] = 1;
        Top<Real> plain = top_of<Real>(problem);
        plain.orientation = normalized(Quaternion<Real>{1, {2, -3, 4}});
        Top<Real> mirrored = plain;
        mirrored.orientation.imaginary = plain.orientation.imaginary.cwiseProduct(sign);
        mirrored.angular_momentum_body = plain.angular_momentum_body.cwiseProduct(sign);
        for (int n = 0; n < 3; ++n) {
          rule.turn(plain, Real(1) / 60);
          rule.turn(mirrored, Real(1) / 60);
        }
        CHECK(mirrored.orientation.real == plain.orientation.real);
        CHECK(same_bits(mirrored.orientation.imaginary,
                        plain.orientation.imaginary.cwiseProduct(sign)));
        CHECK(same_bits(mirrored.angular_momentum_body,
                        plain.angular_momentum_body.cwiseProduct(sign)));
      }
}

TEST_CASE_TEMPLATE("Turn L around, and the splittings retrace their steps", Real, EVERY_PRECISION) {
  for (const TumblingProblem& problem : std::span(tumbling_problems).first(3))
    for (const auto turn :
         {turn_by_splitting<Real>, turn_by_splitting_without_sine<Real>, turn_axis_by_axis<Real>}) {
      const Top<Real> start = top_of<Real>(problem);
      Top<Real> top = start;
      const int steps = 10;
      for (int n = 0; n < steps; ++n) turn(top, Real(1) / 60);
      top.angular_momentum_body *= -1;
      for (int n = 0; n < steps; ++n) turn(top, Real(1) / 60);
      // What one step rounds the later ones magnify: C's moments differ by 26, and its spin turns
      // by 1 rad a step.
      const Real magnified = 26 * steps;
      const Real bound = 2 * steps * turn_error<Real> * magnified;
      CHECK(angle_between(top.orientation, start.orientation) <= bound);
      CHECK(distance<Real>(-top.angular_momentum_body, start.angular_momentum_body) <=
            bound * start.angular_momentum_body.norm());
      // The first-order rule that carries momentum does not.
      Top<Real> carried = start;
      for (int n = 0; n < steps; ++n) turn_carrying_momentum(carried, Real(1) / 60);
      carried.angular_momentum_body *= -1;
      for (int n = 0; n < steps; ++n) turn_carrying_momentum(carried, Real(1) / 60);
      CHECK(angle_between(carried.orientation, start.orientation) > 1e-5);
    }
}

TEST_CASE(
    "After a million steps in float the quaternion is unit, |L| has its length, and the energy "
    "holds") {
  Topf top = top_of<float>(tumbling_problems[0]);
  const Top<long double> start = exactly(top);
  for (int n = 0; n < 1'000'000; ++n) turn_by_splitting(top, 1.0f / 60);
  CHECK(std::abs(norm(top.orientation) - 1) <=
        10 * unit_roundoff<float>);  // renormalized() lets 8 be
  const Top<long double> end = exactly(top);
  // Each step leaves |L| wrong by two roundings either way; a random walk of a million makes a
  // thousand of each, and three times that is rare.
  const long double walk = 3 * 1000 * 2 * unit_roundoff<float>;
  CHECK(std::abs(end.angular_momentum_body.norm() / start.angular_momentum_body.norm() - 1) <=
        walk);
  CHECK(std::abs(kinetic_energy(end) / kinetic_energy(start) - 1) <= 2e-5 + 3 * walk);
}

TEST_CASE_TEMPLATE("A length that is off by roundings is put right, and what is more is left", Real,
                   EVERY_PRECISION) {
  const Vec3<Real> before(3, -4, 12);
  for (const int roundings : {-128, 128}) {
    const Real off = Real(roundings) * unit_roundoff<Real>;
    const Vec3<Real> mended = with_length_of<Real>(before, (1 + off) * before);
    // The first order leaves half the square of `off`; ten roundings come on top.
    CHECK(std::abs(mended.norm() / 13 - 1) <=
          off * off / 2 * Real(1.01) + 10 * unit_roundoff<Real>);
    const Vec3<Real> longer = (1 + 8 * off) * before;
    CHECK(same_bits(with_length_of<Real>(before, longer), longer));
  }
  // Where squares have left the range, nothing is known of the length.
  for (const Real size : {std::numeric_limits<Real>::min(), std::numeric_limits<Real>::max() / 32})
    CHECK(same_bits(with_length_of<Real>(size * before, size * before), size * before));
}

TEST_CASE("A needle's |L| doesn't drift in float: ten minutes leave a random walk of roundings") {
  Topf top = top_of<float>(tumbling_problems[3]);
  const long double start = exactly(top).angular_momentum_body.norm();
  const int steps = 36'000;
  for (int n = 0; n < steps; ++n) turn_by_splitting(top, 1.0f / 60);
  // Two roundings a step; three times the root of the number of steps is rare.
  const long double walk =
      3 * std::sqrt(static_cast<long double>(steps)) * 2 * unit_roundoff<float>;
  CHECK(std::abs(exactly(top).angular_momentum_body.norm() / start - 1) <= walk);
}

TEST_CASE("Turned by the same angle in every step, |L| and |q| don't drift by any splitting") {
  // So slow about two axes that the third one's spin keeps every bit, and with it the angle's sine
  // and cosine: whatever they round, they round the same way 36000 times.
  const int steps = 36'000;
  const long double walk =
      3 * std::sqrt(static_cast<long double>(steps)) * 2 * unit_roundoff<float>;
  for (const auto turn :
       {turn_axis_by_axis<float>, turn_by_splitting<float>, turn_by_splitting_without_sine<float>})
    for (const float spin : {50.0f, 100.0f, 150.0f, 200.0f, 300.0f}) {
      CAPTURE(spin);
      Topf top{.angular_momentum_body = Vec3f(100, 50, spin),
               .inverse_moments = Vec3f(1e-9f, 1e-9f, 1)};
      const long double start = exactly(top).angular_momentum_body.norm();
      for (int n = 0; n < steps; ++n) turn(top, 1.0f / 60);
      CHECK(std::abs(exactly(top).angular_momentum_body.norm() / start - 1) <= walk);
      // renormalized() lets 16 roundings of |q|^2 pass and may misjudge it by 4; |q| has half that.
      const long double imaginary = top.orientation.imaginary.cast<long double>().norm();
      CHECK(std::abs(std::hypot(top.orientation.real, imaginary) - 1) <=
            (16 + 4) * (unit_roundoff<float> / 2) * 1.01L);
    }
}

TEST_CASE_TEMPLATE("A top at rest stays at rest, without a NaN, and so does one too slow to matter",
                   Real, EVERY_PRECISION) {
  for (const Rule<Real>& rule : rules<Real>) {
    CAPTURE(std::string(rule.name));
    Top<Real> top{.inverse_moments = Vec3<Real>(1, Real(0.5), 3)};
    rule.turn(top, Real(1) / 60);
    CHECK(top.orientation.real == 1);
    CHECK(same_bits(top.angular_momentum_body, Vec3<Real>::Zero()));
    top.angular_momentum_body.setConstant(std::numeric_limits<Real>::denorm_min());
    rule.turn(top, Real(1) / 60);
    CHECK(top.orientation.real == 1);
    CHECK(top.angular_momentum_body.allFinite());
    const Top<Real> before = top_of<Real>(tumbling_problems[0]);
    top = before;
    rule.turn(top, Real(0));
    CHECK(same_bits(top.orientation.imaginary, before.orientation.imaginary));
    CHECK(distance(top.angular_momentum_body, before.angular_momentum_body) <=
          2 * unit_roundoff<Real> * 4);
  }
}

TEST_CASE("The T-handle flips when the exact solution says") {
  const Topd start = thrown_t_handle().body.top;
  const exact::FreeTop<long double> exact(exactly(start));
  const int middle = [&] {  // the axis that carries the spin
    int axis = 0;
    start.angular_momentum_body.cwiseAbs().maxCoeff(&axis);
    return axis;
  }();
  const double seconds = 12;
  const auto exact_rate = [&](double time) {
    return static_cast<double>(angular_velocity_body(exact.at(time))[middle]);
  };
  // The moments (s) at which the rate about the shaft passes zero, between the two instants that it
  // has different signs at, as if it were linear there.
  const auto flips = [&](int steps_per_second, const auto& rate_after_step) {
    std::vector<double> times;
    double before = rate_after_step(0);
    for (int n = 1; n <= seconds * steps_per_second; ++n) {
      const double now = rate_after_step(n);
      if ((now > 0) != (before > 0))
        times.push_back((n - 1 + before / (before - now)) / steps_per_second);
      before = now;
    }
    return times;
  };
  const auto truth = flips(4800, [&](int n) { return exact_rate(n / 4800.0); });
  const auto stepped = [&](int steps_per_second) {
    Topd top = start;
    return flips(steps_per_second, [&](int n) {
      if (n > 0) drift(top, 1.0 / steps_per_second);
      return angular_velocity_body(top)[middle];
    });
  };
  const auto coarse = stepped(60), fine = stepped(120);
  REQUIRE(truth.size() == 4);
  REQUIRE(coarse.size() == truth.size());
  REQUIRE(fine.size() == truth.size());
  for (std::size_t n = 0; n < truth.size(); ++n) {
    CHECK(std::abs(coarse[n] - truth[n]) <= 1.0 / 60);  // in the same frame, give or take one
    const double ratio = (coarse[n] - truth[n]) / (fine[n] - truth[n]);
    CHECK(std::abs(ratio - 4) <= 0.05);  // second order, as the rule is
  }
}
